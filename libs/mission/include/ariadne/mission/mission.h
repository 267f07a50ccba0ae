// An exploration in simulation: the robot of sim, the filter of slam and the explorer, tied
// together scan by scan. Here alone the truth and the belief are in one room; the explorer is given
// the belief only.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ariadne/explore/explorer.h"
#include "ariadne/geometry/trajectory.h"
#include "ariadne/sim/params.h"
#include "ariadne/sim/world.h"

namespace ariadne::mission {

/// All sections of an exploration beside the filter's.
struct MissionParams {
  explore::ExploreParams explore;
  sim::SimParams sim;
  slam::SlamParams slam;
};

template <class Params, class F>
void forEachSection(Params& params, F&& f) {
  f("explore", params.explore);
  sim::forEachSection(params.sim, f);
  slam::forEachSection(params.slam, f);
}

/// A moment at which the robot touched rock or glass and was held.
struct Collision {
  double time_s = 0;
  mrpt::math::TPose2D world_from_robot;
};

/// What a mission leaves: enough to map it again to the same bits.
struct MissionRecord {
  std::vector<models::SensorStep> steps;  ///< all that the robot's sensors said
  geometry::Trajectory truth;             ///< world_from_robot at each step
  std::vector<slam::StepReport> reports;  ///< one a filter update
  std::vector<Collision> collisions;      ///< moments of contact, one each time it came about
  double distance_m = 0;                  ///< truly driven
  std::string end_reason;
};

/// Called after each filter update; to say stop, return false.
using MissionListener = std::function<bool(const slam::StepReport&, const explore::Explorer&)>;

/// Robot, filter and explorer tied together, step by step.
class Mission {
 public:
  /// The strategy is applied to the mapping's parameters, see explore::applyStrategy. The filter
  /// and the sensors' noise have params.slam.filter.seed. The world must outlive the mission.
  /// Throws core::UsageError when a parameter is out of bounds, core::Error when the robot cannot
  /// stand at the start.
  Mission(const sim::World& world, const mrpt::math::TPose2D& start, const MissionParams& params,
          int threads);

  /// Explores until the explorer is done or the listener says stop. The same bits for the same
  /// arguments, on any number of threads.
  MissionRecord run(const MissionListener& listener = {});

  /// The filter as of the last step.
  const slam::Mapper& mapper() const { return mapper_; }
  /// The explorer as of the last step.
  const explore::Explorer& explorer() const { return explorer_; }

 private:
  MissionParams params_;
  const sim::World& world_;
  mrpt::math::TPose2D start_;
  slam::Mapper mapper_;
  explore::Explorer explorer_;
};

}  // namespace ariadne::mission
