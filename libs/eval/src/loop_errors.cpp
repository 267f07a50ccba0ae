#include "ariadne/eval/loop_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "ariadne/eval/alignment.h"
#include "ariadne/eval/errors.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::eval {
namespace {

using mrpt::math::TPose2D;

/// A true moment that is looked at, and what the estimate says of it.
struct Moment {
  std::size_t index = 0;
  double travelled_m = 0;
  TPose2D truth;
  TPose2D estimate;
  bool matched = false;
};

std::vector<Moment> momentsOf(const geometry::Trajectory& estimate,
                              const geometry::Trajectory& truth, double max_gap_s, double every_m) {
  std::vector<Moment> moments;
  double travelled = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const TPose2D& here = truth[i].pose;
    if (i > 0) travelled += geometry::distance(here, truth[i - 1].pose);
    if (!moments.empty() && travelled < moments.back().travelled_m + every_m) continue;
    Moment m{i, travelled, here, {}, false};
    m.matched = poseAt(estimate, truth[i].time_s, max_gap_s, m.estimate);
    moments.push_back(m);
  }
  return moments;
}

/// Squares of near_m on a side, so that what is near lies in the same or a neighbouring one.
class Squares {
 public:
  explicit Squares(double side_m) : side_m_(side_m) {}
  void add(const TPose2D& p, std::size_t i) {
    members_[key(column(p.x), column(p.y))].push_back(i);
  }
  /// Calls f(i) for what was added near p and perhaps a little farther.
  template <class F>
  void forEachAbout(const TPose2D& p, F&& f) const {
    for (std::int64_t y = column(p.y) - 1; y <= column(p.y) + 1; ++y)
      for (std::int64_t x = column(p.x) - 1; x <= column(p.x) + 1; ++x)
        if (const auto found = members_.find(key(x, y)); found != members_.end())
          for (const std::size_t i : found->second) f(i);
  }

 private:
  std::int64_t column(double v) const { return static_cast<std::int64_t>(std::floor(v / side_m_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFFU);
  }
  double side_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> members_;
};

LoopError errorAcross(const Moment& a, const Moment& b) {
  const TPose2D error = geometry::relativePose(geometry::relativePose(a.estimate, b.estimate),
                                               geometry::relativePose(a.truth, b.truth));
  return {a.index, b.index, std::hypot(error.x, error.y), std::abs(error.phi) * 180 / M_PI};
}

void summarise(LoopErrors& errors) {
  std::vector<double> translations;
  std::vector<double> headings;
  for (const LoopError& e : errors.closures) {
    if (translations.empty() || e.translation_m > errors.worst_translation.translation_m)
      errors.worst_translation = e;
    if (headings.empty() || e.heading_deg > errors.worst_heading.heading_deg)
      errors.worst_heading = e;
    translations.push_back(e.translation_m);
    headings.push_back(e.heading_deg);
  }
  errors.median_translation_m = figuresOf(std::move(translations)).median;
  errors.median_heading_deg = figuresOf(std::move(headings)).median;
}

}  // namespace

LoopErrors loopErrors(const geometry::Trajectory& estimate, const geometry::Trajectory& truth,
                      double max_gap_s, const LoopParams& params) {
  core::validateFields(params, "loops");
  if (params.near_m >= params.apart_m)
    throw core::UsageError(
        fmt::format("[loops] near_m = {} must be under apart_m = {}: a straight path would be a "
                    "loop otherwise",
                    params.near_m, params.apart_m));
  const auto moments = momentsOf(estimate, truth, max_gap_s, params.every_m);
  LoopErrors errors;
  Squares squares(params.near_m);
  std::size_t entered = 0;  // moments before this one are over apart_m back along the path
  std::vector<std::size_t> firsts;
  for (const Moment& now : moments) {
    while (now.travelled_m - moments[entered].travelled_m > params.apart_m) {
      squares.add(moments[entered].truth, entered);
      ++entered;
    }
    firsts.clear();
    squares.forEachAbout(now.truth, [&](std::size_t i) {
      const TPose2D& then = moments[i].truth;
      if (geometry::distance(now.truth, then) < params.near_m) firsts.push_back(i);
    });
    std::sort(firsts.begin(), firsts.end());
    for (const std::size_t i : firsts) {
      if (now.matched && moments[i].matched)
        errors.closures.push_back(errorAcross(moments[i], now));
      else
        ++errors.unmatched;
    }
  }
  summarise(errors);
  return errors;
}

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::correct:
      return "correct";
    case Verdict::wrong:
      return "wrong";
    case Verdict::no_loop:
      return "no_loop";
  }
  return "";
}

Verdict verdictOf(const LoopErrors& errors, const CorrectBounds& bounds) {
  core::validateFields(bounds, "correct");
  if (errors.closures.empty() && errors.unmatched == 0) return Verdict::no_loop;
  const bool right = errors.unmatched == 0 &&
                     errors.worst_translation.translation_m <= bounds.translation_m &&
                     errors.worst_heading.heading_deg <= bounds.heading_deg;
  return right ? Verdict::correct : Verdict::wrong;
}

}  // namespace ariadne::eval
