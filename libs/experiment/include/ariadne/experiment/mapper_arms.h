// What paired runs and the oracle do to a filter, and nobody else: slam::Mapper names this class
// its friend.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "ariadne/slam/mapper.h"

namespace ariadne::experiment {

/// Forks of a mapper and filters of one hypothesis, for paired runs and the oracle.
class MapperArms {
 public:
  /// A second mapper with the same past, which shares its maps until they are written to, and never
  /// recovers: the other arm of a pair.
  static std::unique_ptr<slam::Mapper> forkWithoutRecovery(const slam::Mapper& mapper) {
    return mapper.forkWithoutRecovery();
  }
  /// Calls in each update when its particles are drawn and weighed, before any resampling.
  static void afterWeighing(slam::Mapper& mapper, std::function<void()> call) {
    mapper.afterWeighing(std::move(call));
  }
  /// Calls each time just before a recovery replaces the particles.
  static void beforeRecovery(slam::Mapper& mapper, std::function<void()> call) {
    mapper.beforeRecovery(std::move(call));
  }
  /// All particles become copies of this one: a filter of its own for one hypothesis.
  /// @param seed what is drawn from now on comes from; not this filter's own, since forks of one
  ///   seed draw the same noise
  static void collapseTo(slam::Mapper& mapper, std::size_t particle, std::uint64_t seed) {
    mapper.collapseTo(particle, seed);
  }
  /// The particles become the s* of the others, one each. The others must have processed the same
  /// steps, and be as many as the particles.
  /// @param weights one each, sum 1
  static void gatherBest(slam::Mapper& mapper,
                         const std::vector<std::unique_ptr<slam::Mapper>>& others,
                         const std::vector<double>& weights) {
    mapper.gatherBest(others, weights);
  }
};

}  // namespace ariadne::experiment
