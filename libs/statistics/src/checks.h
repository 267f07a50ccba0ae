// Checks that the statistics share.
#pragma once
#include <fmt/format.h>

#include "ariadne/core/error.h"

namespace ariadne::statistics {

/// Throws core::UsageError unless 0 < value < 1.
inline void checkShare(double value, const char* name) {
  if (!(value > 0 && value < 1))
    throw core::UsageError(fmt::format("{} = {} is out of bounds: between 0 and 1", name, value));
}

/// Throws core::UsageError unless 0 <= value <= 1.
inline void checkProbability(double value, const char* name) {
  if (!(value >= 0 && value <= 1))
    throw core::UsageError(fmt::format("{} = {} is out of bounds: 0 to 1", name, value));
}

}  // namespace ariadne::statistics
