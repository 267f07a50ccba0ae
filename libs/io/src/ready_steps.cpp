#include "ready_steps.h"

#include <fmt/format.h>

#include <cmath>

#include "ariadne/core/error.h"

namespace ariadne::io {
namespace {

// Lasers take turns, so the labels of all are among the first scans.
constexpr std::size_t kLeastSurveyed = 200;
// What means "no return" shows over some metres of driving: at 40 scans a second, the next 50 s.
constexpr std::size_t kMostSurveyed = 2000;
constexpr std::size_t kMostBeamsSurveyed = 1'000'000;

float checked(const char* name, double value_m) {
  if (!(value_m >= 0 && value_m <= 1000))
    throw core::UsageError(fmt::format("{} is {}, must be 0 to 1000", name, value_m));
  return static_cast<float>(value_m);
}

}  // namespace

ReadySteps::ReadySteps(const DatasetOptions& options, DatasetCounts& counts)
    : counts_(counts), survey_wanted_(options.max_range_m == 0) {
  limits_.min_range_m = checked("min_range_m", options.min_range_m);
  limits_.max_range_m = checked("max_range_m", options.max_range_m);
  counts_.no_return_from_m = options.max_range_m;
}

bool ReadySteps::wantsMore() const {
  return steps_.size() < kLeastSurveyed ||
         (steps_.size() < kMostSurveyed && beams_ < kMostBeamsSurveyed);
}

void ReadySteps::push(RawStep step, double fraction) {
  if (survey_wanted_) survey_.add(step);
  beams_ += step.beams.ranges_m.size();
  steps_.push_back({std::move(step), fraction});
}

void ReadySteps::judge() {
  survey_.judge(counts_.steps == 0);
  if (survey_.reach_m() == limits_.reach_m) return;
  limits_.reach_m = survey_.reach_m();
  counts_.no_return_from_m = std::ceil(static_cast<double>(limits_.reach_m) * 1000) / 1000;
  counts_.no_return_from_step = counts_.steps;
}

std::optional<models::SensorStep> ReadySteps::pop() {
  if (steps_.empty()) return std::nullopt;
  if (survey_wanted_) judge();
  Ready ready = std::move(steps_.front());
  steps_.pop_front();
  beams_ -= ready.step.beams.ranges_m.size();
  fraction_ = ready.fraction;
  setBeams(*ready.step.scan, std::move(ready.step.beams), limits_, counts_);
  ++counts_.steps;
  return std::move(ready.step);
}

}  // namespace ariadne::io
