#include "stock_mapping.h"

#include <fmt/format.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <deque>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::stock_app {
namespace {

using Builder = mrpt::slam::CMetricMapBuilderRBPF;
using mrpt::math::TPose2D;

/// Where on its particle's path a scan lies: behind this update, moved on by odometry.
struct ScanPlace {
  double time_s = 0;
  std::size_t update = 0;
  TPose2D since;
};

/// The stock app's estimate at every scan: the particles' mean.
TPose2D meanPose(const Builder& builder) {
  mrpt::poses::CPose3D mean;
  builder.getCurrentPoseEstimation()->getMean(mean);
  return {mean.x(), mean.y(), mean.yaw()};
}

TPose2D movementOf(const mrpt::obs::CActionCollection& action) {
  if (const auto a3 = action.getActionByClass<mrpt::obs::CActionRobotMovement3D>())
    return TPose2D(a3->poseChange.getMeanVal().asTPose());
  if (const auto a2 = action.getActionByClass<mrpt::obs::CActionRobotMovement2D>())
    return a2->poseChange->getMeanVal().asTPose();
  return {};
}

/// Each update of the filter adds a pose to every particle's path.
std::size_t pathLength(const Builder& builder) {
  return builder.mapPDF.m_particles.front().d->robotPath.size();
}

geometry::Trajectory pathOf(const Builder& builder, const std::vector<ScanPlace>& scans) {
  std::deque<mrpt::math::TPose3D> poses;
  builder.getCurrentMostLikelyPath(poses);
  geometry::Trajectory path;
  path.reserve(scans.size());
  for (const ScanPlace& s : scans)
    path.push_back({s.time_s, geometry::compose(TPose2D(poses.at(s.update)), s.since)});
  return path;
}

}  // namespace

StockRun mapRawlog(const std::string& rawlog, Builder& builder) {
  mrpt::io::CFileGZInputStream file;
  std::string problem;
  if (!file.open(rawlog, problem))
    throw core::Error(fmt::format("cannot read {}: {}", rawlog, problem));
  const std::string wanted =
      rawlog +
      ": rbpf-slam takes rawlogs of actions and frames only (ariadne-dataset import makes such)";
  auto archive = mrpt::serialization::archiveFrom(file);
  StockRun run;
  std::vector<ScanPlace> scans;
  std::size_t entry = 0;
  mrpt::obs::CActionCollection::Ptr action;
  mrpt::obs::CSensoryFrame::Ptr frame;
  mrpt::obs::CObservation::Ptr observation;
  TPose2D since;
  double neff_sum = 0;
  run.neff_share_min = 1;
  while (mrpt::obs::CRawlog::getActionObservationPairOrObservation(archive, action, frame,
                                                                   observation, entry)) {
    if (!action || !frame || frame->empty()) throw core::Error(wanted);
    since = geometry::compose(since, movementOf(*action));
    const std::size_t before = pathLength(builder);
    builder.processActionObservation(*action, *frame);
    if (pathLength(builder) > before) {
      since = {};
      const double share = builder.mapPDF.ESS();
      neff_sum += share;
      run.neff_share_min = std::min(run.neff_share_min, share);
      ++run.updates;
    }
    const double time_s = mrpt::Clock::toDouble((*frame->begin())->timestamp);
    run.mean.push_back({time_s, meanPose(builder)});
    scans.push_back({time_s, pathLength(builder) - 1, since});
  }
  if (scans.empty() || run.updates == 0) throw core::Error(wanted);
  run.neff_share_mean = neff_sum / static_cast<double>(run.updates);
  run.path = pathOf(builder, scans);
  return run;
}

}  // namespace ariadne::stock_app
