#include "ariadne/core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace ariadne::core {

namespace {

/// TBB allows as many threads as there are cores unless told otherwise, and warns on stderr.
void allowMoreThreadsThanCores() {
  constexpr std::size_t kMost = 256;
  static const tbb::global_control control(tbb::global_control::max_allowed_parallelism, kMost);
}

}  // namespace

struct Parallel::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

Parallel::Parallel(int threads)
    : threads_(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency())) {
  if (threads_ <= 1) return;
  allowMoreThreadsThanCores();
  arena_ = std::make_unique<Arena>(threads_);
}

Parallel::~Parallel() = default;

#if defined(__SANITIZE_THREAD__)

// Debian's TBB is not instrumented: ThreadSanitizer cannot see how it synchronises and would report
// every particle. Plain threads stand in for it in that preset.
void Parallel::forEach(std::size_t count, const std::function<void(std::size_t)>& body) const {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(guard);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> others;
  for (int t = 1; t < threads_; ++t) others.emplace_back(work);
  work();
  for (auto& t : others) t.join();
  if (failure) std::rethrow_exception(failure);
}

#else

void Parallel::forEach(std::size_t count, const std::function<void(std::size_t)>& body) const {
  if (!arena_) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
        },
        tbb::simple_partitioner{});
  });
}

#endif

}  // namespace ariadne::core
