// What a Mapper holds.
#pragma once
#include <functional>

#include "ariadne/core/parallel.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/grid/insertion/scan.h"
#include "ariadne/loops/closing/loop_closer.h"
#include "ariadne/slam/mapper.h"
#include "ariadne/slam/pose_path.h"
#include "dead_reckoning.h"
#include "recapture.h"

namespace ariadne::slam {

struct Mapper::Impl {
  Impl(const SlamParams& params, int threads, const mrpt::maps::CSimpleMap& before,
       const mrpt::math::TPose2D& start);
  bool due(const models::SensorStep& step) const;
  std::optional<Recaptured> recaptured(const grid::Scan& scan);
  StepReport update(const grid::Scan& scan, const mrpt::math::TPose2D& motion,
                    const std::optional<Recaptured>& told);

  SlamParams params;
  std::shared_ptr<const mrpt::maps::CSimpleMap> known;
  std::shared_ptr<core::Parallel> parallel;  // forks work on the same threads
  filter::ParticleSet particles;
  loops::LoopCloser loops;
  DeadReckoning reckoning;
  Recapture recapture;
  DoubtCounts doubts;
  std::vector<OdometryRecord> records;
  std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> scans;  // one an update
  StageTimes times;
  std::function<void()> after_weighing;
  std::function<void()> before_recovery;
};

}  // namespace ariadne::slam
