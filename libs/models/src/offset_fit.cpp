#include "ariadne/models/offset_fit.h"

#include <algorithm>
#include <cmath>

namespace ariadne::models {
namespace {

constexpr std::size_t kWindow = 200;
constexpr double kPriorSteps = 4;       // the given width counts as this many steps
constexpr double kBiasPriorSteps = 30;  // and a bias of zero as this many of a metre
constexpr int kRounds = 3;
constexpr double kFarthest = 2.5;

}  // namespace

void OffsetFit::add(const Innovation& step) {
  if (last_.size() < kWindow) {
    last_.push_back(step);
  } else {
    last_[next_] = step;
    next_ = (next_ + 1) % kWindow;
  }
  for (int round = 0; round < kRounds; ++round) {
    double squares = kPriorSteps;
    double top = 0;
    double bottom = kBiasPriorSteps;
    for (const Innovation& s : last_) {
      const double variance = scale2_ * s.variance_wide + s.variance_match;
      const double share = scale2_ * s.variance_wide / variance;  // of the odometry
      const double most = kFarthest * std::sqrt(variance);
      const double off = std::clamp(s.off - bias_ * s.travel_m, -most, most);
      squares += (share * share * off * off + share * s.variance_match) / s.variance_wide;
      const double weight = bias_sigma_ * bias_sigma_ / variance;
      top += weight * s.travel_m * (off + bias_ * s.travel_m);
      bottom += weight * s.travel_m * s.travel_m;
    }
    scale2_ = squares / (kPriorSteps + static_cast<double>(last_.size()));
    bias_ = top / bottom;
  }
}

double OffsetFit::scale() const { return std::sqrt(scale2_); }

}  // namespace ariadne::models
