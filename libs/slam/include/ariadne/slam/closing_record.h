// What happened at each loop: for loops.json and for experiments.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/closing/loop_watcher.h"
#include "ariadne/filter/ancestry.h"

namespace ariadne::slam {

/// Poses of a particle set at one update, with normalised weights.
struct WeightedPoses {
  std::vector<mrpt::math::TPose2D> poses;  ///< map_from_robot
  std::vector<double> weights;
};

/// The set that was saved at a detection, next to the one that there was at te.
struct SavingRecord {
  std::size_t entries = 0;
  std::size_t distinct_ancestors = 0;  ///< of the entries, at te
  std::size_t existed = 0;             ///< distinct hypotheses that there were at te
  WeightedPoses at_te;                 ///< the particles as they were at te, with weights of then
  WeightedPoses saved;                 ///< Eq. (11) and (12)
  double memory_mb = 0;
};

struct RecoveryRecord {
  std::size_t update = 0;                   ///< after which the set was replaced
  std::size_t distinct_before = 0;          ///< ancestors at te of the set that was replaced
  std::size_t distinct_after = 0;           ///< and of the one that came
  std::size_t distinct_sources = 0;         ///< ways through the loop that were drawn
  std::vector<double> contradiction;        ///< of each particle, see recovery::RecoveredSet
  double seconds = 0;                       ///< wall clock
  std::vector<filter::AncestorPtr> before;  ///< the set that was replaced
  std::vector<double> weights_before;
  std::vector<filter::AncestorPtr> after;  ///< and the one that came
};

struct ClosingRecord {
  closing::Closing closing;
  std::optional<SavingRecord> saving;
  std::optional<RecoveryRecord> recovery;
  std::string note;  ///< why there was no recovery, where there was none
};

}  // namespace ariadne::slam
