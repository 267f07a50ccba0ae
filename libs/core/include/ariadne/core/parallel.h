// Loops over particles on a fixed number of threads (oneTBB).
#pragma once
#include <cstddef>
#include <functional>
#include <memory>

namespace ariadne::core {

/// Runs bodies on `threads` threads. A body must touch only what belongs to its index.
class Parallel {
 public:
  /// @param threads 1 runs in the caller; 0 takes one thread a core.
  explicit Parallel(int threads);
  ~Parallel();
  /// Threads that work, this one included.
  int threads() const { return threads_; }
  /// Calls body(i) for i in [0, count). The first exception is rethrown.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& body) const;

 private:
  struct Arena;
  int threads_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace ariadne::core
