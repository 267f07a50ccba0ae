#include "steps_json.h"

#include <algorithm>

#include "frame_json.h"

namespace ariadne::report {
namespace {

using Json = nlohmann::ordered_json;

/// A value a step; null where there is none.
template <class F>
Json column(const Replay& replay, F&& value) {
  Json out = Json::array();
  for (const ReplayStep& s : replay.steps) out.push_back(value(s));
  return out;
}

/// [first step, value] of each run of equal values.
template <class F>
Json runs(const Replay& replay, F&& value) {
  Json out = Json::array();
  for (std::size_t i = 0; i < replay.steps.size(); ++i)
    if (i == 0 || value(replay.steps[i]) != value(replay.steps[i - 1]))
      out.push_back({i, value(replay.steps[i])});
  return out;
}

template <class T, class F>
Json orNull(const std::optional<T>& v, F&& value) {
  return v ? Json(value(*v)) : Json();
}

Json poseJson(const mrpt::math::TPose2D& p) {
  return {rounded(100 * p.x), rounded(100 * p.y), rounded(1000 * p.phi)};
}

}  // namespace

nlohmann::ordered_json stepsJson(const Replay& r) {
  const auto milli = [](double v) { return rounded(1000 * v); };
  const auto same = [](std::size_t v) { return v; };
  const double start_s = r.steps.empty() ? 0 : r.steps.front().time_s;
  double before_s = start_s;
  double set_back_s = 0;  // the page's time goes on where a log's clock was set back
  const auto elapsed = [&](auto& s) {
    set_back_s += std::max(0.0, before_s - s.time_s);
    before_s = s.time_s;
    return milli(s.time_s - start_s + set_back_s);
  };
  return {{"time_ms", column(r, elapsed)},
          {"distance_cm", column(r, [&](auto& s) { return rounded(100 * s.distance_m); })},
          {"neff_milli", column(r, [&](auto& s) { return milli(s.neff); })},
          {"resampled", column(r, [&](auto& s) { return s.resampled ? 1 : 0; })},
          {"ancestors", column(r, [&](auto& s) { return orNull(s.unique_ancestors, same); })},
          {"pose_entropy_milli", column(r, [&](auto& s) { return milli(s.pose_entropy); })},
          {"map_entropy_milli", column(r, [&](auto& s) { return orNull(s.map_entropy, milli); })},
          {"error_mm", column(r, [&](auto& s) { return orNull(s.error_m, milli); })},
          {"pose", column(r, [&](auto& s) { return poseJson(s.map_from_robot); })},
          {"truth", column(r, [&](auto& s) { return orNull(s.truth, poseJson); })},
          {"loop", runs(r, [&](auto& s) { return static_cast<int>(s.loop_state); })},
          {"state", runs(r, [&](auto& s) { return s.state; })}};
}

}  // namespace ariadne::report
