// Sections IV and V on a robot that is driven by somebody else: extends the graph of places of
// every particle, watches for loops, saves the set as of the entry and recovers it afterwards.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <vector>

#include "ariadne/core/parallel.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/grid/insertion/scan.h"
#include "ariadne/loops/closing/closing_record.h"
#include "ariadne/loops/closing/loop_watcher.h"
#include "ariadne/loops/recovery/params.h"
#include "ariadne/loops/recovery/saved_stack.h"
#include "ariadne/loops/search/finder.h"

namespace ariadne::loops {

/// What closing loops needs to know of a run's parameters.
struct LoopCloserParams {
  ClosingParams closing;
  RecoveryParams recovery;
  grid::GridParams grid;
  grid::LikelihoodParams likelihood;
  std::size_t checkpoint_updates = 1;  ///< each particle keeps its map each time after so many
  std::uint64_t seed = 1;
};

/// What an update tells about loops.
struct LoopReport {
  LoopState state = LoopState::exploring;
  std::size_t opportunities = 0;     ///< |I(s*)|, Eq. (7); 0 also while none is looked for
  std::optional<double> dist_m;      ///< to the entry point by the map, m
  std::optional<double> dist_g;      ///< and by the graph, m
  std::size_t unique_ancestors = 0;  ///< of the set at te of the open closing, else c2 of path ago
};

/// Of one update, after its scan was inserted: extend(), watch(), recover() when a closing has
/// ended, search().
class LoopCloser {
 public:
  using Scans = std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>;  ///< of all updates so far

  /// Throws core::UsageError when a parameter is out of bounds. `parallel` must outlive it.
  LoopCloser(const LoopCloserParams& params, const core::Parallel& parallel);

  /// Takes the update in: each particle's pose into its graph of places G, the scan into what
  /// closures are searched among.
  void extend(const filter::ParticleSet& particles, const grid::Scan& scan);

  /// What watch() saw.
  struct Watched {
    LoopReport report;
    std::optional<std::size_t> ended;  ///< id of the closing that ended
  };
  /// Looks for I(s*), Eq. (7), saves the set when a loop is detected, and tells when a closing
  /// ends.
  /// @param neff of this update, Eq. (10)
  Watched watch(const filter::ParticleSet& particles, double neff);

  /// Whether recover() will replace the particles: a set is saved and recovery is on.
  bool holds(std::size_t closing) const {
    return params_.recovery.enabled && stack_.holds(closing);
  }
  /// Replaces the particles by those saved for the closing, propagated through the loop; leaves
  /// them where none were saved or recovery is off.
  void recover(std::size_t closing, filter::ParticleSet& particles, const Scans& scans);

  /// Looks for the place at which a loop should close, and when it is found draws every particle's
  /// path anew, given it.
  void search(filter::ParticleSet& particles, const Scans& scans);
  /// In the order in which they were found.
  const std::vector<FoundClosure>& found() const { return found_; }

  /// G of every particle.
  const std::vector<PlaceGraph>& graphs() const { return graphs_; }
  /// For particles that were replaced from outside; one per particle.
  void setGraphs(std::vector<PlaceGraph> graphs) {
    graphs_ = std::move(graphs);
    unique_.reset();
  }
  /// All closings so far, open ones too.
  std::vector<ClosingRecord> records() const;
  /// The open closings, the outermost first; until the next update.
  std::vector<const Closing*> openClosings() const { return watcher_.allOpen(); }
  /// What is drawn from now on comes from this seed.
  void reseed(std::uint64_t seed) { params_.seed = seed; }
  /// From now on closings end without recovery.
  void disableRecovery() { params_.recovery.enabled = false; }

 private:
  ClosingStep figuresOf(const filter::ParticleSet& particles, double neff);
  void save(std::size_t id, const filter::ParticleSet& particles);
  std::size_t lookBack(std::size_t step) const;
  std::size_t uniqueAncestors(const filter::ParticleSet& particles, std::size_t step);

  struct UniqueAncestors {
    std::size_t at = 0;  ///< update
    std::size_t count = 0;
  };
  struct PastSet {
    geometry::WeightedPoses particles;
    std::size_t distinct = 0;
  };
  struct Outcome {
    std::optional<SavingRecord> saving;
    std::optional<RecoveryRecord> recovery;
    std::string note;
    bool dropped = false;  ///< its saved set, for memory
  };

  LoopCloserParams params_;
  const core::Parallel& parallel_;
  LoopWatcher watcher_;
  SavedStack stack_;
  Finder finder_;
  std::vector<FoundClosure> found_;
  std::vector<PlaceGraph> graphs_;
  std::vector<PastSet> past_;        // by update
  std::vector<double> travelled_m_;  // by update
  std::vector<Outcome> outcomes_;    // by closing
  std::optional<UniqueAncestors> unique_;
};

}  // namespace ariadne::loops
