#include "ariadne/batch/worker.h"

#include <fmt/format.h>
#include <signal.h>

#include "ariadne/batch/claims.h"
#include "ariadne/batch/figures.h"
#include "ariadne/core/error.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

fs::path fresh(const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  return folder;
}

Process start(const Store& store, const Plan& plan, const PlannedRun& run, const fs::path& out) {
  return {runCommand(plan.arms[run.arm].program, run.arguments, store.config(run.config), out,
                     plan.limits),
          {}};
}

bool saysDiskIsFull(const std::string& words) {
  return words.find("No space left on device") != std::string::npos ||
         words.find("Disk quota exceeded") != std::string::npos;
}

}  // namespace

Worker::Worker(const Store& store, const Plan& plan, const PlannedRun& run, fs::path out)
    : store_(store),
      plan_(plan),
      run_(run),
      out_(fresh(out)),
      process_(start(store, plan, run, out_)) {}

Worker::~Worker() {
  process_.stop();
  std::error_code ignored;
  fs::remove_all(out_, ignored);
}

std::optional<RunResult> Worker::poll() {
  const auto end = process_.poll();
  if (!end) {
    if (!too_long_ && process_.elapsed_s() > plan_.limits.time_s) {
      too_long_ = true;
      process_.kill();
    }
    return std::nullopt;
  }
  // SIGKILL: a scheduler that ends a whole job may come to the run a moment before it comes to us.
  was_told_ =
      !too_long_ && (end->signal == SIGINT || end->signal == SIGTERM || end->signal == SIGKILL ||
                     end->exit_code == 128 + SIGINT || end->exit_code == 128 + SIGTERM);
  return resultOf(*end);
}

RunResult Worker::resultOf(const ProcessEnd& end) const {
  RunResult result;
  result.key = run_.key;
  result.about = describe(plan_, run_);
  result.wall_s = end.wall_s;
  result.cpu_s = end.cpu_s;
  result.host = hostName();
  if (too_long_) {
    result.failure = fmt::format("took longer than its limit of {} s", plan_.limits.time_s);
  } else if (end.signal != 0 || end.exit_code != 0) {
    result.failure = describe(end);
  } else {
    try {
      result.figures = figuresOf(plan_.arms[run_.arm], out_);
    } catch (const core::Error& e) {
      result.failure = fmt::format("exit code 0, but no result: {}", e.what());
    }
  }
  if (result.failure.empty()) return result;
  result.last_words = end.last_words;
  if (saysDiskIsFull(end.last_words))
    throw core::Error(fmt::format("{}: {}", result.about, end.last_words));
  return result;
}

void Worker::keepFiles() const {
  if (!plan_.limits.keep_files) return;
  const fs::path place = store_.files(run_.key);
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  fs::remove_all(place, error);
  fs::rename(out_, place, error);
  if (error) throw core::Error(fmt::format("cannot keep {}: {}", place.string(), error.message()));
}

}  // namespace ariadne::batch
