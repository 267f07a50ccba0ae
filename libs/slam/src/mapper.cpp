#include "ariadne/slam/mapper.h"

#include <mrpt/core/bits_math.h>

#include <chrono>
#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/grid/insertion/scan.h"
#include "mapper_impl.h"
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

Mapper::Impl::Impl(const SlamParams& p, int threads, const mrpt::maps::CSimpleMap& before,
                   const TPose2D& start)
    : params(validated(p)),
      known(std::make_shared<mrpt::maps::CSimpleMap>(before)),
      parallel(std::make_shared<core::Parallel>(threads)),
      particles(modelsOf(params), *parallel, start, gridOf(before, params.grid)),
      loops(loopsOf(params), *parallel),
      reckoning(params.motion),
      recapture(params.matcher, params.filter.proposal_gain) {}

bool Mapper::Impl::due(const models::SensorStep& step) const {
  if (!step.scan) return false;
  const auto& doubt = reckoning.doubt();
  if (scans.empty() || (doubt && doubt->claimed)) return true;
  const TPose2D moved = reckoning.sinceUpdate();
  return std::hypot(moved.x, moved.y) >= params.update.update_distance_m ||
         std::abs(moved.phi) >= mrpt::DEG2RAD(params.update.update_angle_deg);
}

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
    if (after_weighing) after_weighing();
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

}  // namespace ariadne::slam
