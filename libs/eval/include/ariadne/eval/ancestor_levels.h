// Walks the lines of many particles towards the root at once, step by step, and visits each
// ancestor once however many descend from it: N lines of T steps cost the number of distinct
// ancestors, not more.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ariadne/filter/ancestry.h"

namespace ariadne::eval {

/// Walks back through the ancestry of a particle set, one filter update at a time.
class AncestorLevels {
 public:
  /// Distinct ancestors, without owning them.
  using Nodes = std::vector<const filter::Ancestor*>;

  /// Stands at the leaves' latest step. Null leaves have no ancestors and are left out. The leaves
  /// must outlive the walk.
  explicit AncestorLevels(const std::vector<filter::AncestorPtr>& leaves);

  /// True when the walk is above all roots.
  bool done() const { return level_.empty(); }
  /// The update at which the walk stands.
  std::size_t step() const { return step_; }
  /// The distinct ancestors at step(); the leaves themselves where they are of that step.
  const Nodes& level() const { return level_; }
  /// On to the next earlier step at which there is an ancestor.
  void up();

 private:
  void meet(const filter::Ancestor* node);
  void takeLatest();

  Nodes frontier_;  // distinct, one or more a line, of any step
  Nodes level_;     // those of the latest step
  std::size_t step_ = 0;
  Nodes next_;
  // Which nodes next_ holds: open addressing, and slots of earlier rounds count as empty, so that
  // nothing is cleared between the steps.
  struct Slot {
    const filter::Ancestor* node = nullptr;
    std::uint32_t round = 0;
  };
  std::vector<Slot> slots_;
  std::uint32_t round_ = 0;
  int shift_ = 0;
};

}  // namespace ariadne::eval
