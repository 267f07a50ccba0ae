#include "carmen_fan.h"

#include <cmath>

namespace ariadne::io {
namespace {

constexpr double kDegree = M_PI / 180;

bool isWhole(double value) { return std::abs(value - std::round(value)) < 1e-4 * (1 + value); }

/// A resolution that lasers have: a fraction of a degree, or of a turn in 1024 parts (Hokuyo).
bool isUsual(double step_deg) {
  return isWhole(step_deg * 12) || isWhole(step_deg * 16) || isWhole(step_deg / 360 * 1024);
}

}  // namespace

CarmenFan fanOfField(double field_deg, std::size_t count) {
  const auto n = static_cast<double>(count);
  const bool end_missing =
      !isUsual(field_deg / (n - 1)) && (isUsual(field_deg / n) || count % 2 == 0);
  const double field = field_deg * kDegree;
  return {-field / 2, field / (end_missing ? n : n - 1)};
}

CarmenFan fanOfStep(double step_deg, std::size_t count) {
  const auto n = static_cast<double>(count);
  const bool end_missing = count % 2 == 0 && isWhole(n * step_deg);
  return {-(end_missing ? n : n - 1) * step_deg / 2 * kDegree, step_deg * kDegree};
}

double spanOf(const CarmenFan& fan, std::size_t count) {
  return std::abs(fan.step_rad) * (static_cast<double>(count) - 1) / kDegree;
}

CarmenFan mirrored(const CarmenFan& fan) { return {-fan.start_rad, -fan.step_rad}; }

bool areAlike(const CarmenFan& a, const CarmenFan& b, std::size_t count) {
  return std::abs(spanOf(a, count) - spanOf(b, count)) * kDegree < 1.5 * std::abs(a.step_rad);
}

std::optional<CarmenFan> knownFan(std::size_t count) {
  switch (count - count % 2) {
    case 180:
    case 360:
      return fanOfField(180, count);
    case 100:
    case 200:
    case 400:
      return fanOfField(100, count);
    default:
      return std::nullopt;
  }
}

}  // namespace ariadne::io
