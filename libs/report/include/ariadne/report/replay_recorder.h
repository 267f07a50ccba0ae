// Makes a Replay while a run goes on: fed once a filter update, cheap, bounded in memory. Keyframes
// are taken as often as their number allows: each time there are too many every other one goes, and
// from then on they are taken half as often.
#pragma once
#include <memory>
#include <vector>

#include "ariadne/filter/particle.h"
#include "ariadne/report/replay.h"
#include "ariadne/slam/mapper.h"

namespace ariadne::report {

/// A look at the filter after an update; valid until the next one.
struct FilterView {
  std::vector<const filter::Particle*> particles;  ///< not null, each with an ancestor
  std::vector<double> weights;                     ///< normalised, one per particle
  std::size_t best = 0;                            ///< index of s*
  const loops::PlaceGraph* graph = nullptr;        ///< of s*; null where none is kept
};

/// Of the filter as it is now; nothing is copied.
FilterView viewOf(const slam::Mapper& mapper);

/// How much a replay may hold.
struct RecorderParams {
  std::size_t max_frames = 500;
  std::size_t max_tiles = 30000;     ///< distinct ones, 256 bytes each
  std::size_t max_particles = 200;   ///< drawn of one set; of more every n-th
  int max_side_px = 1536;            ///< of the drawn map; a larger one gets larger pixels
  double path_spacing_m = 0.2;       ///< between the drawn points of the path
  std::size_t max_clouded = 250000;  ///< particles drawn in all of the run
  std::size_t updates_a_frame = 4;   ///< at first; more for a long run
};

/// Records a run as it goes, for report.html.
class ReplayRecorder {
 public:
  /// Nothing is recorded yet.
  explicit ReplayRecorder(const RecorderParams& params = {});
  ~ReplayRecorder();
  ReplayRecorder(const ReplayRecorder&) = delete;
  ReplayRecorder& operator=(const ReplayRecorder&) = delete;

  /// Drawn in all keyframes from the next update on, until something else is shown.
  void show(ReplayScene scene);
  /// Belongs to the next update (its `step` is set by that), which gets a keyframe that stays;
  /// after the last one to that.
  void mark(ReplayMoment moment);
  /// To be called after each filter update. An update at which the loop state changes gets a
  /// keyframe that stays.
  /// @param state of the robot in words
  /// Throws core::Error when weights are not normalised or not one per particle.
  void step(const slam::StepReport& report, const FilterView& view, std::string state);

  /// What was recorded, ending with a keyframe of the last update; the recorder is then as new.
  /// Title, facts, notes and what is known only afterwards are the caller's.
  /// @param last the filter after the last update
  Replay finish(const FilterView& last);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ariadne::report
