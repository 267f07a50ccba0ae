// Sections IV and V on a robot that is driven by somebody else: extends the graph of places of
// every particle, watches for loops, saves the set as of the entry and recovers it afterwards.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <optional>
#include <vector>

#include "ariadne/closing/loop_watcher.h"
#include "ariadne/closure/finder.h"
#include "ariadne/core/parallel.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/recovery/saved_stack.h"
#include "ariadne/slam/closing_record.h"
#include "ariadne/slam/params.h"
#include "ariadne/slam/step_report.h"

namespace ariadne::slam {

class LoopCloser {
 public:
  /// Throws core::UsageError when a parameter is out of bounds. `parallel` must outlive it.
  LoopCloser(const SlamParams& params, const core::Parallel& parallel);

  /// To be called after each filter update, its scan inserted. Fills what the report says about
  /// loops. Returns the closing that ended, from which recover() is to be called.
  std::optional<std::size_t> update(const filter::ParticleSet& particles, StepReport& report);
  /// Replaces the particles by those saved for the closing, propagated through the loop; leaves
  /// them where none were saved or recovery is off.
  /// @param scans of all updates so far
  void recover(std::size_t closing, filter::ParticleSet& particles,
               const std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>& scans);

  /// Looks for the place at which a loop should close, and when it is found draws every particle's
  /// way anew, given it. To be called after each update and its recovery.
  void search(filter::ParticleSet& particles,
              const std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>& scans);
  const std::vector<FoundClosure>& found() const { return found_; }

  /// G of every particle.
  const std::vector<topology::PlaceGraph>& graphs() const { return graphs_; }
  /// For particles that were replaced from outside; one a particle.
  void setGraphs(std::vector<topology::PlaceGraph> graphs) {
    graphs_ = std::move(graphs);
    unique_.reset();
  }
  /// All closings so far, open ones too.
  std::vector<ClosingRecord> records() const;
  /// The open closings, the outermost first; until the next update.
  std::vector<const closing::Closing*> openClosings() const { return watcher_.allOpen(); }
  /// What is drawn from now on comes from this seed.
  void reseed(std::uint64_t seed) { params_.filter.seed = seed; }
  /// From now on closings end without recovery.
  void disableRecovery() { params_.recovery.enabled = false; }

 private:
  void extendGraphs(const filter::ParticleSet& particles);
  closing::ClosingStep figuresOf(const filter::ParticleSet& particles, const StepReport& report);
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

  SlamParams params_;
  const core::Parallel& parallel_;
  closing::LoopWatcher watcher_;
  recovery::SavedStack stack_;
  closure::Finder finder_;
  std::vector<FoundClosure> found_;
  std::vector<topology::PlaceGraph> graphs_;
  std::vector<PastSet> past_;        // by update
  std::vector<double> travelled_m_;  // by update
  std::vector<Outcome> outcomes_;    // by closing
  std::optional<UniqueAncestors> unique_;
};

}  // namespace ariadne::slam
