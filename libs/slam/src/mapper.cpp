#include "ariadne/slam/mapper.h"

#include <mrpt/core/bits_math.h>

#include <chrono>
#include <cmath>
#include <functional>

#include "ariadne/core/error.h"
#include "ariadne/core/parallel.h"
#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/insertion/scan.h"
#include "ariadne/grid/map/conversion.h"
#include "ariadne/loops/closing/loop_closer.h"
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
  loops::validate(params.loop_closing, "loop_closing");
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

loops::LoopCloserParams loopsOf(const SlamParams& p) {
  return {p.loop_closing,
          p.recovery,
          p.grid,
          p.likelihood,
          static_cast<std::size_t>(p.update.checkpoint_updates),
          p.filter.seed};
}

}  // namespace

struct Mapper::Impl {
  Impl(const SlamParams& p, int threads, const mrpt::maps::CSimpleMap& before, const TPose2D& start)
      : params(validated(p)),
        known(std::make_shared<mrpt::maps::CSimpleMap>(before)),
        parallel(std::make_shared<core::Parallel>(threads)),
        particles(modelsOf(params), *parallel, start, gridOf(before, params.grid)),
        loops(loopsOf(params), *parallel),
        reckoning(params.motion),
        recapture(params.matcher, params.filter.proposal_gain) {}

  bool due(const models::SensorStep& step) const {
    if (!step.scan) return false;
    const auto& doubt = reckoning.doubt();
    if (scans.empty() || (doubt && doubt->claimed)) return true;
    const TPose2D moved = reckoning.sinceUpdate();
    return std::hypot(moved.x, moved.y) >= params.update.update_distance_m ||
           std::abs(moved.phi) >= mrpt::DEG2RAD(params.update.update_angle_deg);
  }

  std::optional<Recaptured> recaptured(const grid::Scan& scan);
  StepReport update(const grid::Scan& scan, const TPose2D& motion,
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
  std::function<void()> before_recovery;
};

/// The motion since the last update where the odometry alone does not tell it.
std::optional<Recaptured> Mapper::Impl::recaptured(const grid::Scan& scan) {
  const auto& doubt = reckoning.doubt();
  if (!doubt || scans.empty()) return std::nullopt;
  Stopwatch watch(times.predict_s);
  const Recaptured found =
      recapture(particles[particles.best()], scan.features, reckoning.sinceUpdate(), *doubt);
  if (doubt->claimed) {
    doubts.jumps_by_scan += found.by == Recaptured::By::scan;
    doubts.jumps_by_odometry += found.by == Recaptured::By::odometry;
    doubts.jumps_guessed += found.by == Recaptured::By::guess;
  }
  return found;
}

/// One update, in the paper's order.
/// @param motion of the odometry since the last update
/// @param told it, where the odometry alone does not tell it
StepReport Mapper::Impl::update(const grid::Scan& scan, const TPose2D& motion,
                                const std::optional<Recaptured>& told) {
  StepReport report;
  report.step = particles.step();
  report.particles = particles.size();
  {
    Stopwatch watch(times.predict_s);
    if (told)
      particles.predict(told->motion, told->covariance);
    else
      particles.predict(motion);
    particles.match(scan);
    particles.weigh(scan);
    report.neff = particles.neff();  // Eq. (10)
    if (report.neff < params.filter.beta * static_cast<double>(particles.size()))
      particles.resample();
  }
  {
    Stopwatch watch(times.insert_s);
    particles.insert(scan, static_cast<std::size_t>(params.update.checkpoint_updates));
    scans.push_back(scan.raw);
  }
  {
    Stopwatch watch(times.loops_s);
    loops.extend(particles, scan);
    const auto watched = loops.watch(particles, report.neff);
    if (watched.ended) {
      if (before_recovery && loops.holds(*watched.ended)) before_recovery();
      loops.recover(*watched.ended, particles, scans);
    }
    loops.search(particles, scans);
    report.loops = watched.report;
  }
  report.resampled = particles.figures().resampled;
  report.matches_accepted = particles.figures().matches_accepted;
  report.log_likelihood = particles.figures().log_likelihood;
  report.best = particles.best();
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
  if (!std::isfinite(step.time_s)) throw core::Error("the time of a step is no number");
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
  const TPose2D motion = m.scans.empty() ? TPose2D() : m.reckoning.sinceUpdate();
  const grid::Scan scan = grid::takeScan(step.scan, m.params.grid,
                                         static_cast<std::size_t>(m.params.matcher.max_beams));
  const auto known = m.recaptured(scan);
  // Across a jump the odometry's own motion is taken out of the path between the updates.
  if (known && m.reckoning.doubt()->claimed) here = m.reckoning.afterUpdate(known->motion);
  m.reckoning.update(here);
  m.records.push_back({step.time_s, here, m.scans.size() + 1, true});
  StepReport report = m.update(scan, motion, known);
  report.time_s = step.time_s;
  return report;
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
    impl_->loops.setGraphs(std::vector<loops::PlaceGraph>(n, graphs()[particle]));
}

void Mapper::gatherBest(const std::vector<std::unique_ptr<Mapper>>& others,
                        const std::vector<double>& weights) {
  std::vector<filter::Particle> particles;
  std::vector<loops::PlaceGraph> of_each;
  for (const auto& other : others) {
    const std::size_t best = other->particles().best();
    particles.push_back(other->particles()[best]);
    if (!graphs().empty()) of_each.push_back(other->graphs()[best]);
  }
  impl_->particles.replace(std::move(particles), weights);
  impl_->loops.setGraphs(std::move(of_each));
}

void Mapper::beforeRecovery(std::function<void()> call) {
  impl_->before_recovery = std::move(call);
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

const std::vector<loops::PlaceGraph>& Mapper::graphs() const { return impl_->loops.graphs(); }
std::vector<loops::ClosingRecord> Mapper::closings() const { return impl_->loops.records(); }

const std::vector<loops::FoundClosure>& Mapper::foundClosures() const {
  return impl_->loops.found();
}
const models::MotionLearner& Mapper::learnedMotion() const { return impl_->particles.learned(); }

std::vector<const loops::Closing*> Mapper::openClosings() const {
  return impl_->loops.openClosings();
}

StageTimes Mapper::times() const { return impl_->times; }
std::size_t Mapper::updates() const { return impl_->scans.size(); }
const DoubtCounts& Mapper::doubts() const { return impl_->doubts; }

}  // namespace ariadne::slam
