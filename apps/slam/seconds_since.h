#pragma once
#include <chrono>

namespace ariadne::slam_app {

/// Time on the clock since `start`, s.
inline double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace ariadne::slam_app
