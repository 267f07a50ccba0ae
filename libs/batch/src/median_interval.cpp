#include "median_interval.h"

namespace ariadne::batch {
namespace {

/// Puts the ends of a 95 % interval on an order statistic, as 9999 does; of 10,000 runs with four
/// figures it is a second, not five.
constexpr std::size_t kResamples = 1999;

}  // namespace

statistics::Interval medianInterval95(const std::vector<double>& values) {
  core::RandomStream rng(1, 0, 0, core::Purpose::bootstrap);
  return statistics::medianInterval(values, rng, 0.95, kResamples);
}

}  // namespace ariadne::batch
