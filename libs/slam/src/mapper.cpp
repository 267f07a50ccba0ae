#include "ariadne/slam/mapper.h"

#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/core/bits_math.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/random/RandomGenerators.h>

#include <chrono>
#include <cmath>
#include <functional>

#include "ariadne/core/parallel.h"
#include "ariadne/core/random.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/conversion.h"
#include "ariadne/grid/scan_shape.h"
#include "ariadne/slam/loop_closer.h"
#include "ariadne/slam/pose_path.h"
#include "dead_reckoning.h"
#include "recapture.h"
#include "simple_map.h"

namespace ariadne::slam {
namespace {

using mrpt::math::TPose2D;

const SlamParams& validated(const SlamParams& params) {
  forEachSection(params,
                 [](const char* section, const auto& p) { core::validateFields(p, section); });
  closing::validate(params.loop_closing, "loop_closing");
  return params;
}

filter::FilterModels modelsOf(const SlamParams& p) {
  return {p.filter, p.motion, p.matcher, p.grid, p.likelihood};
}

/// Adds the seconds of its life to `sum`.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum), start_(Clock::now()) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point start_;
};

/// @param covariance zero: the motion model's
mrpt::obs::CActionCollection actionOf(const TPose2D& increment, const Eigen::Matrix3d& covariance) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.poseChange.get_ptr() = mrpt::poses::CPosePDFGaussian::Create(
      mrpt::poses::CPose2D(increment), mrpt::math::CMatrixDouble33(covariance));
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

/// MRPT draws resampling indices from its generator, of which every thread has its own: the one
/// place where it is seeded.
void seedMrpt(std::uint64_t seed, std::size_t step) {
  core::RandomStream stream(seed, static_cast<std::uint32_t>(step), 0, core::Purpose::resampling);
  mrpt::random::getRandomGenerator().randomize(stream.bits());
}

}  // namespace

struct Mapper::Impl {
  Impl(const SlamParams& p, int threads, const mrpt::maps::CSimpleMap& before, const TPose2D& start)
      : params(validated(p)),
        known(std::make_shared<mrpt::maps::CSimpleMap>(before)),
        parallel(std::make_shared<core::Parallel>(threads)),
        particles(modelsOf(params), *parallel, start, gridOf(before, params.grid)),
        loops(params, *parallel),
        reckoning(params.motion),
        recapture(params.matcher, params.filter.proposal_gain) {
    particle_filter.m_options = filter::particleFilterOptions(params.filter);
  }

  bool due(const models::SensorStep& step) const {
    if (!step.scan) return false;
    const auto& doubt = reckoning.doubt();
    if (scans.empty() || (doubt && doubt->claimed)) return true;
    const TPose2D moved = reckoning.sinceUpdate();
    return std::hypot(moved.x, moved.y) >= params.update.update_distance_m ||
           std::abs(moved.phi) >= mrpt::DEG2RAD(params.update.update_angle_deg);
  }

  std::optional<Recaptured> recaptured(const mrpt::obs::CObservation2DRangeScan& scan);
  StepReport update(const models::SensorStep& step, const TPose2D& motion,
                    const Eigen::Matrix3d& covariance);

  SlamParams params;
  std::shared_ptr<const mrpt::maps::CSimpleMap> known;
  std::shared_ptr<core::Parallel> parallel;  // forks work on the same threads
  filter::ParticleSet particles;
  LoopCloser loops;
  mrpt::bayes::CParticleFilter particle_filter;
  DeadReckoning reckoning;
  Recapture recapture;
  DoubtCounts doubts;
  std::vector<OdometryRecord> records;
  std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> scans;  // one an update
  StageTimes times;
  std::function<void()> before_recovery;
};

/// The motion since the last update where the odometry alone does not tell it.
std::optional<Recaptured> Mapper::Impl::recaptured(const mrpt::obs::CObservation2DRangeScan& scan) {
  const auto& doubt = reckoning.doubt();
  if (!doubt || scans.empty()) return std::nullopt;
  Stopwatch watch(times.predict_s);
  const Recaptured found =
      recapture(particles[particles.best()], grid::scanFeatures(scan, params.grid.insert_range_m),
                reckoning.sinceUpdate(), *doubt);
  if (doubt->claimed) {
    doubts.jumps_by_scan += found.by == Recaptured::By::scan;
    doubts.jumps_by_odometry += found.by == Recaptured::By::odometry;
    doubts.jumps_guessed += found.by == Recaptured::By::guess;
  }
  return found;
}

StepReport Mapper::Impl::update(const models::SensorStep& step, const TPose2D& motion,
                                const Eigen::Matrix3d& covariance) {
  const auto action = actionOf(motion, covariance);
  mrpt::obs::CSensoryFrame observation;
  observation.insert(step.scan);

  StepReport report;
  report.step = particles.step();
  report.time_s = step.time_s;
  seedMrpt(params.filter.seed, particles.step());
  mrpt::bayes::CParticleFilter::TParticleFilterStats stats;
  {
    Stopwatch watch(times.predict_s);
    particle_filter.executeOn(particles, &action, &observation, &stats);
  }
  report.particles = particles.size();
  // Eq. (10); MRPT's ESS is Neff / N.
  report.neff = stats.ESS_beforeResample * static_cast<double>(report.particles);
  report.resampled = particles.figures().resampled;
  report.matches_accepted = particles.figures().matches_accepted;
  report.log_likelihood = particles.figures().log_likelihood;
  {
    Stopwatch watch(times.insert_s);
    particles.insertScan(static_cast<std::size_t>(params.update.checkpoint_updates));
  }
  scans.push_back(step.scan);
  report.best = particles.best();
  {
    Stopwatch watch(times.loops_s);
    if (const auto ended = loops.update(particles, report)) {
      if (before_recovery) before_recovery();
      loops.recover(*ended, particles, scans);
    }
    loops.search(particles, scans);
  }
  report.best = particles.best();  // recovery may have brought another
  report.map_from_robot = particles[report.best].map_from_robot;
  return report;
}

Mapper::Mapper(const SlamParams& params, int threads) : Mapper(params, threads, {}, {0, 0, 0}) {}
Mapper::Mapper(const SlamParams& params, int threads, const mrpt::maps::CSimpleMap& known,
               const TPose2D& start)
    : impl_(std::make_unique<Impl>(params, threads, known, start)) {}
Mapper::Mapper(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Mapper::~Mapper() = default;

std::optional<StepReport> Mapper::process(const models::SensorStep& step) {
  Impl& m = *impl_;
  TPose2D here = m.reckoning.add(step);
  const bool due = m.due(step);
  const bool blind = due && grid::isBlind(*step.scan, m.params.grid, m.params.update.least_returns);
  if (blind) {
    m.reckoning.passBlind();
    ++m.doubts.blind_scans;
  }
  if (!due || blind) {
    m.records.push_back({step.time_s, here, m.scans.size(), false});
    return std::nullopt;
  }
  TPose2D motion = m.scans.empty() ? TPose2D() : m.reckoning.sinceUpdate();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  if (const auto found = m.recaptured(*step.scan)) {
    // Across a jump the odometry's own way is taken out of the path between the updates.
    if (m.reckoning.doubt()->claimed) here = m.reckoning.afterUpdate(found->motion);
    motion = found->motion;
    covariance = found->covariance;
  }
  m.reckoning.update(here);
  m.records.push_back({step.time_s, here, m.scans.size() + 1, true});
  return m.update(step, motion, covariance);
}

std::unique_ptr<Mapper> Mapper::forkWithoutRecovery() const {
  std::unique_ptr<Mapper> other(new Mapper(std::make_unique<Impl>(*impl_)));
  other->impl_->before_recovery = nullptr;
  other->impl_->loops.disableRecovery();
  return other;
}

void Mapper::collapseTo(std::size_t particle, std::uint64_t seed) {
  impl_->params.filter.seed = seed;
  impl_->particles.reseed(seed);
  impl_->loops.reseed(seed);
  const std::size_t n = impl_->particles.size();
  const filter::Particle one = impl_->particles[particle];
  impl_->particles.replace(std::vector<filter::Particle>(n, one),
                           std::vector<double>(n, 1.0 / static_cast<double>(n)));
  if (!graphs().empty())
    impl_->loops.setGraphs(std::vector<topology::PlaceGraph>(n, graphs()[particle]));
}

void Mapper::gatherBest(const std::vector<std::unique_ptr<Mapper>>& others,
                        const std::vector<double>& weights) {
  std::vector<filter::Particle> particles;
  std::vector<topology::PlaceGraph> of_each;
  for (const auto& other : others) {
    const std::size_t best = other->particles().best();
    particles.push_back(other->particles()[best]);
    if (!graphs().empty()) of_each.push_back(other->graphs()[best]);
  }
  impl_->particles.replace(std::move(particles), weights);
  impl_->loops.setGraphs(std::move(of_each));
}

void Mapper::onRecovery(std::function<void()> before) {
  impl_->before_recovery = std::move(before);
}

mrpt::maps::COccupancyGridMap2D Mapper::map() const {
  return grid::toMrpt(impl_->particles[impl_->particles.best()].map);
}

geometry::Trajectory Mapper::path() const { return pathOf(impl_->particles.best()); }

geometry::Trajectory Mapper::pathOf(std::size_t particle) const {
  return posePath(impl_->records, impl_->particles[particle].ancestor);
}

TPose2D Mapper::pose() const {
  const TPose2D& last = impl_->particles[impl_->particles.best()].map_from_robot;
  if (impl_->scans.empty()) return last;
  return geometry::compose(last, impl_->reckoning.sinceUpdate());
}

const filter::ParticleSet& Mapper::particles() const { return impl_->particles; }

mrpt::maps::CSimpleMap Mapper::simpleMap() const {
  return simpleMapOf(*impl_->known, impl_->scans,
                     impl_->particles[impl_->particles.best()].ancestor);
}

const std::vector<topology::PlaceGraph>& Mapper::graphs() const { return impl_->loops.graphs(); }
std::vector<ClosingRecord> Mapper::closings() const { return impl_->loops.records(); }

const std::vector<FoundClosure>& Mapper::foundClosures() const { return impl_->loops.found(); }
const models::MotionLearner& Mapper::learnedMotion() const { return impl_->particles.learned(); }

std::vector<const closing::Closing*> Mapper::openClosings() const {
  return impl_->loops.openClosings();
}

StageTimes Mapper::times() const { return impl_->times; }
std::size_t Mapper::updates() const { return impl_->scans.size(); }
const DoubtCounts& Mapper::doubts() const { return impl_->doubts; }

}  // namespace ariadne::slam
