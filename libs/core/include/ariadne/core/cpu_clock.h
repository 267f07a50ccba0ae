// Time that the calling thread has computed: what a step costs, whoever else uses the machine.
#pragma once
#include <ctime>

namespace ariadne::core {

/// CPU time of the calling thread since its start, s.
inline double threadCpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace ariadne::core
