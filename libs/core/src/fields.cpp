#include "ariadne/core/fields.h"

namespace ariadne::core {

std::string describe(const Bounds& bounds) {
  const bool low = std::isfinite(bounds.min);
  const bool high = std::isfinite(bounds.max);
  if (low && high) return fmt::format("{} to {}", bounds.min, bounds.max);
  if (low) return fmt::format("{} or more", bounds.min);
  if (high) return fmt::format("{} or less", bounds.max);
  return "any number";
}

}  // namespace ariadne::core
