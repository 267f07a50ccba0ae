// A program as a child process: in a process group of its own, gone with its parent, with the last
// of what it says on stderr.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ariadne::process {

/// How a process ended, and what it took.
struct ProcessEnd {
  int exit_code = 0;  ///< when no signal ended it
  int signal = 0;
  double wall_s = 0;
  double cpu_s = 0;      ///< with the children it waited for
  double memory_mb = 0;  ///< largest resident set, MiB
  std::string last_words;
};

/// A child process; ends with this object.
class Process {
 public:
  /// @param argv program (its path) and arguments
  /// @param stdout_file takes what it prints; empty: nothing does
  /// Throws core::Error when it cannot be started.
  Process(const std::vector<std::string>& argv, const std::filesystem::path& stdout_file);
  /// Kills what still runs.
  ~Process();
  /// Takes the child over.
  Process(Process&& other) noexcept;
  Process& operator=(Process&&) = delete;

  /// Takes what is on stderr (never blocks) and returns the end once there is one.
  std::optional<ProcessEnd> poll();
  /// SIGKILL to the whole group.
  void kill();
  /// The same, and waits for the end.
  void stop();
  /// Since it was started, s.
  double elapsed_s() const;
  /// Of the system; -1 once it has ended.
  pid_t pid() const { return pid_; }

 private:
  friend void waitForAny(const std::vector<const Process*>&, std::chrono::milliseconds);
  void drain();
  pid_t pid_ = -1;
  int pipe_ = -1;
  int end_ = -1;  ///< pidfd: readable once the process has ended
  std::chrono::steady_clock::time_point start_;
  std::string tail_;
};

/// Returns when one has ended or says something, a signal comes, or after `longest`.
void waitForAny(const std::vector<const Process*>& processes, std::chrono::milliseconds longest);

/// Waits for the end, at most `limit_s`; then throws core::Error that calls the process `what`.
ProcessEnd endOf(Process& process, double limit_s, const std::string& what);

/// "killed by signal 11 (Segmentation fault)", "exit code 1".
std::string describe(const ProcessEnd& end);

}  // namespace ariadne::process
