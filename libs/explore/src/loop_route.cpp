#include "ariadne/explore/loop_route.h"

#include <cmath>
#include <vector>

#include "ariadne/geometry/pose.h"

namespace ariadne::explore {
namespace {

constexpr double kPassed_m = 1;
constexpr double kAhead_m = 3;

/// Positions of the updates first .. last on the line.
std::vector<mrpt::math::TPoint2D> positions(const filter::AncestorPtr& leaf, std::size_t first,
                                            std::size_t last) {
  std::vector<mrpt::math::TPoint2D> out(last - first + 1);
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    if (a.step() >= first && a.step() <= last) out[a.step() - first] = {a.pose().x, a.pose().y};
    return a.step() > first;
  });
  return out;
}

}  // namespace

double LoopRoute::laps() const {
  const double length = entered_ > te_ ? static_cast<double>(entered_ - te_) : 1;
  return whole_laps_ + static_cast<double>(cursor_ - te_) / length;
}

mrpt::math::TPoint2D LoopRoute::next(const filter::AncestorPtr& leaf,
                                     const mrpt::math::TPose2D& robot) {
  const auto path = positions(leaf, te_, entered_);
  const auto place = [&](std::size_t update) { return path[update - te_]; };
  if (cursor_ >= entered_) {
    cursor_ = te_;
    ahead_ = te_;
    ++whole_laps_;
  }
  // The robot may have come to where it was sent on another route than the path's.
  const auto near = [&](std::size_t update) {
    return geometry::distance(place(update), robot) < kPassed_m;
  };
  for (std::size_t update = ahead_; update > cursor_; --update)
    if (near(update)) cursor_ = update;
  while (cursor_ < entered_ && near(cursor_)) ++cursor_;
  ahead_ = cursor_;
  double ahead_m = 0;
  while (ahead_ < entered_ && ahead_m < kAhead_m) {
    ahead_m += geometry::distance(place(ahead_ + 1), place(ahead_));
    ++ahead_;
  }
  return place(ahead_);
}

}  // namespace ariadne::explore
