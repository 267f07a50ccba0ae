// floor() and ceil() to int without the library call that plain x86-64 makes of them.
#pragma once

namespace ariadne::grid {

/// Largest integer not over v; |v| must be under 2^31.
inline int floorToInt(double v) {
  const int i = static_cast<int>(v);
  return i - (v < i);
}

/// Smallest integer not under v; |v| must be under 2^31.
inline int ceilToInt(double v) {
  const int i = static_cast<int>(v);
  return i + (v > i);
}

}  // namespace ariadne::grid
