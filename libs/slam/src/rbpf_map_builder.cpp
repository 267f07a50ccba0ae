#include "ariadne/slam/rbpf_map_builder.h"

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFParticles.h>

#include <algorithm>
#include <fstream>
#include <type_traits>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::slam {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TPose3D;

/// Odometry of the action; none when it has none.
std::optional<TPose2D> movementOf(const mrpt::obs::CActionCollection& action) {
  if (const auto a3 = action.getActionByClass<mrpt::obs::CActionRobotMovement3D>())
    return TPose2D(a3->poseChange.getMeanVal().asTPose());
  if (const auto a2 = action.getBestMovementEstimation())
    return a2->poseChange->getMeanVal().asTPose();
  return std::nullopt;
}

mrpt::obs::CObservation2DRangeScan::Ptr planarScanOf(const mrpt::obs::CSensoryFrame& frame) {
  for (const auto& observation : frame) {
    auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(observation);
    if (scan && scan->isPlanarScan(0.1)) return scan;
  }
  return nullptr;
}

template <class T>
T asDeclared(const mrpt::maps::CMultiMetricMap& map) {
  if constexpr (std::is_pointer_v<T>)
    return &map;
  else
    return map;
}

}  // namespace

RbpfMapBuilder::RbpfMapBuilder(const TConstructionOptions& construction)
    : params_(construction.resolved()), threads_(construction.threads) {
  setLoggerName("RbpfMapBuilder");
  setMinLoggingLevel(construction.verbosity_level);
  initialize();
}

RbpfMapBuilder::~RbpfMapBuilder() = default;

void RbpfMapBuilder::initialize(const mrpt::maps::CSimpleMap& initial_map,
                                const mrpt::poses::CPosePDF* x0) {
  TPose2D start;
  if (x0)
    start = x0->getMeanVal().asTPose();
  else if (!initial_map.empty())
    start = TPose2D(initial_map.rbegin()->pose->getMeanVal().asTPose());
  initial_size_ = initial_map.size();
  mapper_ = std::make_unique<Mapper>(params_, threads_, initial_map, start);
  odom_from_robot_ = odom_at_update_ = TPose2D();
  steps_ = 0;
  metric_map_.reset();
}

void RbpfMapBuilder::processActionObservation(mrpt::obs::CActionCollection& action,
                                              mrpt::obs::CSensoryFrame& observations) {
  if (const auto movement = movementOf(action))
    odom_from_robot_ = geometry::compose(odom_from_robot_, *movement);
  else
    MRPT_LOG_WARN("Action contains no odometry.");
  models::SensorStep step;
  step.scan = planarScanOf(observations);
  step.odom_from_robot = odom_from_robot_;
  ++steps_;
  step.time_s = step.scan && step.scan->timestamp != INVALID_TIMESTAMP
                    ? mrpt::Clock::toDouble(step.scan->timestamp)
                    : steps_;
  const auto report = mapper_->process(step);
  m_statsLastIteration.observationsInserted = report.has_value();
  if (!report) return;
  odom_at_update_ = odom_from_robot_;
  metric_map_.reset();
  MRPT_LOG_INFO_FMT("update %zu: Neff %.1f of %zu%s", report->step, report->neff, report->particles,
                    report->resampled ? ", resampled" : "");
}

mrpt::poses::CPose3DPDF::Ptr RbpfMapBuilder::getCurrentPoseEstimation() const {
  const auto& particles = mapper_->particles();
  const TPose2D since = geometry::relativePose(odom_at_update_, odom_from_robot_);
  auto pdf = mrpt::poses::CPose3DPDFParticles::Create(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    pdf->m_particles[i].d = TPose3D(geometry::compose(particles[i].map_from_robot, since));
    pdf->m_particles[i].log_w = particles.getW(i);
  }
  return pdf;
}

void RbpfMapBuilder::getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const {
  out_map = mapper_->simpleMap();
}

unsigned int RbpfMapBuilder::getCurrentlyBuiltMapSize() {
  return static_cast<unsigned>(initial_size_ + mapper_->updates());
}

RbpfMapBuilder::BuiltMap RbpfMapBuilder::getCurrentlyBuiltMetricMap() const {
  if (!metric_map_) {
    metric_map_ = std::make_unique<mrpt::maps::CMultiMetricMap>();
    metric_map_->maps.push_back(mrpt::maps::COccupancyGridMap2D::Create(mapper_->map()));
  }
  return asDeclared<BuiltMap>(*metric_map_);
}

void RbpfMapBuilder::saveCurrentEstimationToImage(const std::string& file, bool) {
  if (!mapper_->map().saveAsBitmapFile(file)) throw core::Error("cannot write " + file);
}

std::deque<TPose3D> RbpfMapBuilder::updatesOf(std::size_t particle) const {
  std::deque<TPose3D> path;
  forEachAncestor(mapper_->particles()[particle].ancestor, [&](const filter::Ancestor& a) {
    path.emplace_front(a.pose());
    return true;
  });
  return path;
}

void RbpfMapBuilder::getCurrentMostLikelyPath(std::deque<TPose3D>& out_path) const {
  out_path = updatesOf(mapper_->particles().best());
}

void RbpfMapBuilder::saveCurrentPathEstimationToTextFile(const std::string& file) {
  std::ofstream out(file);
  for (std::size_t i = 0; i < mapper_->particles().size(); ++i) {
    for (const TPose3D& p : updatesOf(i))
      out << fmt::format("{:.4f} {:.4f} {:.4f} ", p.x, p.y, p.yaw);
    out << '\n';
  }
  out.close();
  if (!out) throw core::Error("cannot write " + file);
}

}  // namespace ariadne::slam
