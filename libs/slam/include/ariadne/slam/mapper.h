// The mapping loop: sensor steps in, filter updates out. RbpfMapBuilder is this behind MRPT's
// CMetricMapBuilder; the apps use it as it is.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>

#include <functional>
#include <memory>
#include <optional>

#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/loops/closing/closing_record.h"
#include "ariadne/models/sensor_step.h"
#include "ariadne/slam/params.h"
#include "ariadne/slam/step_report.h"

namespace ariadne::experiment {
class MapperArms;
}

namespace ariadne::slam {

/// Wall-clock seconds by stage, summed over all updates.
struct StageTimes {
  double predict_s = 0;  ///< motion model, scan match, proposal, weight, resampling
  double insert_s = 0;   ///< scans into maps, checkpoints
  double loops_s = 0;    ///< graphs of places, detection, saving, recovery
};

/// Steps at which odometry and scan alone did not tell the motion as usual.
struct DoubtCounts {
  std::size_t blind_scans = 0;        ///< due for an update, but hardly a beam returned: none made
  std::size_t jumps_by_scan = 0;      ///< odometry jumped; the scan told where the robot was
  std::size_t jumps_by_odometry = 0;  ///< odometry jumped; the scan fitted where it jumped to
  std::size_t jumps_guessed = 0;      ///< odometry jumped; no scan told, the robot stayed
};

/// The whole of it: a log's steps in, a map and a path out. Start here.
class Mapper {
 public:
  /// @param threads 0 takes one per core. Throws core::UsageError when a parameter is out of
  /// bounds.
  Mapper(const SlamParams& params, int threads);
  /// Goes on in a known map: scans with poses, and where the robot is now (map_from_robot).
  Mapper(const SlamParams& params, int threads, const mrpt::maps::CSimpleMap& known,
         const mrpt::math::TPose2D& start);
  ~Mapper();
  Mapper(const Mapper&) = delete;
  Mapper& operator=(const Mapper&) = delete;

  /// Takes the next step. Its stamp may lie before the last one's, where a clock was set back: the
  /// order of the calls is the order of the drive. Throws core::Error when it is no number. Returns
  /// the report when the filter was updated, nothing when the robot has not moved far enough or the
  /// scan shows nothing ([update] least_returns); the step then only adds to the path, along the
  /// odometry.
  std::optional<StepReport> process(const models::SensorStep& step);

  /// The map of s*, as MRPT's grid.
  mrpt::maps::COccupancyGridMap2D map() const;
  /// The path of s*: one pose (map_from_robot) for every step that was processed; between filter
  /// updates along the odometry.
  geometry::Trajectory path() const;
  /// The known map, then the scans that the filter used with the poses of s*; for MRPT's tools.
  mrpt::maps::CSimpleMap simpleMap() const;
  /// Where s* is now (map_from_robot): its last update, then along the odometry.
  mrpt::math::TPose2D pose() const;
  /// The current hypotheses.
  const filter::ParticleSet& particles() const;
  /// The path of any hypothesis, as path().
  geometry::Trajectory pathOf(std::size_t particle) const;
  /// G of every hypothesis; empty where loop closing is not enabled.
  const std::vector<loops::PlaceGraph>& graphs() const;
  /// All closings so far.
  std::vector<loops::ClosingRecord> closings() const;
  /// Closures that were searched for and found, in their order.
  const std::vector<loops::FoundClosure>& foundClosures() const;
  /// What the log told about its odometry.
  const models::MotionLearner& learnedMotion() const;
  /// Those that are open, the outermost first; until the next step is processed.
  std::vector<const loops::Closing*> openClosings() const;
  /// Where the time went since the start.
  StageTimes times() const;
  /// Of the odometry's jumps and blind stretches.
  const DoubtCounts& doubts() const;
  /// Filter updates up to now.
  std::size_t updates() const;

 private:
  friend class experiment::MapperArms;  // what paired runs do to a filter
  struct Impl;
  explicit Mapper(std::unique_ptr<Impl> impl);
  std::unique_ptr<Mapper> forkWithoutRecovery() const;
  void collapseTo(std::size_t particle, std::uint64_t seed);
  void gatherBest(const std::vector<std::unique_ptr<Mapper>>& others,
                  const std::vector<double>& weights);
  void afterWeighing(std::function<void()> call);
  void beforeRecovery(std::function<void()> call);
  std::unique_ptr<Impl> impl_;
};

}  // namespace ariadne::slam
