// One run of a plan as a process: started, watched, its result taken.
#pragma once
#include <filesystem>
#include <optional>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"
#include "ariadne/process/process.h"

namespace ariadne::batch {

using process::Process;
using process::ProcessEnd;

/// One run under way in a scratch folder of its own.
class Worker {
 public:
  /// @param out a folder that the run gets for itself; its parents exist
  /// All references must outlive the worker. Throws core::Error when it cannot be started.
  Worker(const Store& store, const Plan& plan, const PlannedRun& run, std::filesystem::path out);
  /// Kills a run that has not ended; its folder goes.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// The result once there is one; kills a run over its time limit. Throws core::Error when the
  /// disk is full: that is no result of the run.
  std::optional<RunResult> poll();
  /// Whether the run that ended was told to by SIGINT, SIGTERM or SIGKILL, not by us.
  bool wasTold() const { return was_told_; }
  /// Moves the files of a successful run to their place, where that was asked for.
  void keepFiles() const;
  /// The run as planned.
  const PlannedRun& run() const { return run_; }
  /// Its process, to wait for.
  const Process& process() const { return process_; }

 private:
  RunResult resultOf(const ProcessEnd& end) const;
  const Store& store_;
  const Plan& plan_;
  const PlannedRun& run_;
  std::filesystem::path out_;
  Process process_;
  bool too_long_ = false;
  bool was_told_ = false;
};

}  // namespace ariadne::batch
