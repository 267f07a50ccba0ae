// What happened at each loop: for loops.json and for experiments.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/filter/ancestry.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/loops/closing/loop_watcher.h"

namespace ariadne::loops {

/// The set that was saved at a detection, next to the one that there was at te.
struct SavingRecord {
  std::size_t entries = 0;
  std::size_t distinct_ancestors = 0;  ///< of the entries, at te
  std::size_t existed = 0;             ///< distinct hypotheses that there were at te
  geometry::WeightedPoses
      at_te;  ///< the particles as they were at te, with the weights of that update
  geometry::WeightedPoses saved;  ///< Eq. (11) and (12)
  double memory_mb = 0;
};

/// One recovery as it was.
struct RecoveryRecord {
  std::size_t update = 0;                   ///< after which the set was replaced
  std::size_t distinct_before = 0;          ///< ancestors at te of the set that was replaced
  std::size_t distinct_after = 0;           ///< and of the one that came
  std::size_t distinct_sources = 0;         ///< paths through the loop that were drawn
  std::vector<double> contradiction;        ///< of each particle, see RecoveredSet
  double seconds = 0;                       ///< wall clock
  std::vector<filter::AncestorPtr> before;  ///< the set that was replaced
  std::vector<double> weights_before;
  std::vector<filter::AncestorPtr> after;  ///< and the one that came
};

/// A closure that was searched for and found from metres away.
struct FoundClosure {
  std::size_t update = 0;   ///< after which the paths were drawn anew
  std::size_t anchor = 0;   ///< update at the place that the robot is back at
  std::size_t begin = 0;    ///< the paths were drawn anew from this update on
  double correction_m = 0;  ///< of s*
  double correction_deg = 0;
  double hit_share = 0;     ///< of the last metres' beams end on what was there before
  double second_share = 0;  ///< the same at the second-best place
  double cost = 0;          ///< half the squared Mahalanobis distance of what s* had to be moved by
  double seconds = 0;       ///< wall clock of drawing
};

/// One loop from its detection to what its end brought, for loops.json and pictures.
struct ClosingRecord {
  Closing closing;
  std::optional<SavingRecord> saving;
  std::optional<RecoveryRecord> recovery;
  std::string note;  ///< why there was no recovery, where there was none
  /// What could have been recovered was dropped, since sets took too much memory.
  bool dropped = false;
};

}  // namespace ariadne::loops
