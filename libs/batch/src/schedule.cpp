#include "ariadne/batch/schedule.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <deque>
#include <list>
#include <thread>

#include "ariadne/batch/claims.h"
#include "ariadne/batch/worker.h"
#include "planned_files.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

double cpuOfThis_s() {
  rusage u{};
  ::getrusage(RUSAGE_SELF, &u);
  return static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

class Scheduler {
 public:
  Scheduler(const Store& store, const Plan& plan, const ScheduleOptions& options)
      : store_(store), plan_(plan), options_(options), files_(plan.files), claims_(store.claims()) {
    const auto runs = distinctRuns(plan);
    for (std::size_t i = options.slice - 1; i < runs.size(); i += options.slices) {
      ++progress_.planned;
      if (store.has(runs[i]->key))
        ++progress_.finished;
      else
        pending_.push_back(runs[i]);
    }
    claims_.buryDead([&](const std::string& owner) { store_.clearAfter(owner); });
  }

  ~Scheduler() {
    workers_.clear();  // kills; claims are given back after that
    std::error_code ignored;
    fs::remove_all(store_.scratch(claims_.owner()), ignored);
    fs::remove(store_.scratch("").parent_path(), ignored);  // only when it is empty
  }

  ScheduleEnd run() {
    const auto start = Clock::now();
    if (!pending_.empty()) files_.check();
    while (!(end_.stopped = options_.stop()) && step(start)) {
    }
    end_.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
    end_.own_cpu_s = cpuOfThis_s();
    return end_;
  }

 private:
  /// False when all has its result.
  bool step(Clock::time_point start) {
    claims_.refresh();
    fill();
    if (workers_.empty()) {
      if (others_.empty()) return false;
      waitForOthers();
      return true;
    }
    std::vector<const Process*> processes;
    for (const Worker& w : workers_) processes.push_back(&w.process());
    waitForAny(processes, milliseconds(50));
    std::list<Worker> ended;
    std::vector<RunResult> results;
    for (auto w = workers_.begin(); w != workers_.end();) {
      const auto at = w++;
      const auto result = at->poll();
      if (!result) continue;
      if (at->wasTold() && stopComes()) return true;
      results.push_back(*result);
      ended.splice(ended.end(), workers_, at);
    }
    fill();  // the next runs go on while these results go to the disk
    auto result = results.begin();
    for (const Worker& w : ended) finish(w, *result++, start);
    return true;
  }

  void fill() {
    while (!pending_.empty() && workers_.size() < static_cast<std::size_t>(options_.jobs)) {
      const PlannedRun& run = *pending_.front();
      pending_.pop_front();
      if (store_.has(run.key)) {
        ++progress_.finished;
      } else if (!claims_.take(run.key)) {
        others_.push_back(&run);
      } else if (store_.has(run.key)) {  // stored and given back between the two
        claims_.giveBack(run.key, true);
        ++progress_.finished;
      } else {
        workers_.emplace_back(store_, plan_, run, store_.scratch(claims_.owner()) / run.key);
      }
    }
  }

  void waitForOthers() {
    std::this_thread::sleep_for(milliseconds(200));
    pending_.swap(others_);  // those with a result are counted, the dead's are done
  }

  /// A signal to a whole group of processes may reach the run a little before us.
  bool stopComes() const {
    for (int i = 0; i < 20; ++i) {
      if (options_.stop()) return true;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return false;
  }

  void finish(const Worker& worker, const RunResult& result, Clock::time_point start) {
    files_.check();  // may have been built again while the run went on
    if (result.failure.empty()) worker.keepFiles();
    store_.put(result);
    claims_.giveBack(result.key, true);
    ++end_.done;
    end_.failed += result.failure.empty() ? 0 : 1;
    end_.runs_cpu_s += result.cpu_s;
    ++progress_.finished;
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
    progress_.left_s = elapsed_s / static_cast<double>(end_.done) *
                       static_cast<double>(progress_.planned - progress_.finished);
    progress_.about = result.about;
    progress_.result = &result;
    options_.tell(progress_);
  }

  const Store& store_;
  const Plan& plan_;
  const ScheduleOptions& options_;
  PlannedFiles files_;
  Claims claims_;
  std::deque<const PlannedRun*> pending_;
  std::deque<const PlannedRun*> others_;  ///< claimed by somebody else
  std::list<Worker> workers_;
  ScheduleProgress progress_;
  ScheduleEnd end_;
};

}  // namespace

ScheduleEnd doRuns(const Store& store, const Plan& plan, const ScheduleOptions& options) {
  return Scheduler(store, plan, options).run();
}

}  // namespace ariadne::batch
