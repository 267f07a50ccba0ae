#include "child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;
constexpr int kCannotStart = 127;

std::string lastLine(const fs::path& log) {
  std::istringstream text(io::readWhole(log));
  std::string last;
  for (std::string line; std::getline(text, line);)
    if (!line.empty()) last = line;
  return last.empty() ? "it said nothing" : last;
}

/// In the child: never returns. Only calls that are safe behind a fork.
[[noreturn]] void become(char* const* arguments, int log) {
  if (::dup2(log, STDOUT_FILENO) >= 0 && ::dup2(log, STDERR_FILENO) >= 0)
    ::execv(arguments[0], arguments);
  ::_exit(kCannotStart);
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

bool canRun(const fs::path& program) {
  std::error_code ignored;
  return fs::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0;
}

}  // namespace

ProcessCosts runChild(const std::vector<std::string>& command, const fs::path& log) {
  std::vector<char*> arguments;
  for (const std::string& a : command) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0)
    throw core::Error(fmt::format("cannot write {}: {}", log.string(), strerror(errno)));
  const auto start = std::chrono::steady_clock::now();
  // Not vfork or posix_spawn: the child's peak would then begin at all of this process's memory.
  const pid_t child = ::fork();
  if (child == 0) become(arguments.data(), file);
  const int fork_error = errno;
  ::close(file);
  if (child < 0)
    throw core::Error(fmt::format("cannot start {}: {}", command.front(), strerror(fork_error)));
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0)
    if (errno != EINTR)
      throw core::Error(fmt::format("lost {}: {}", command.front(), strerror(errno)));
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (WIFSIGNALED(status))
    throw core::Error(fmt::format("{} was killed by signal {} ({}); its log: {}", command.front(),
                                  WTERMSIG(status), strsignal(WTERMSIG(status)), log.string()));
  if (WEXITSTATUS(status) == kCannotStart)
    throw core::Error(fmt::format("{} cannot be started", command.front()));
  if (WEXITSTATUS(status) != 0)
    throw core::Error(fmt::format("{} failed with exit code {}: {} (all it said: {})",
                                  command.front(), WEXITSTATUS(status), lastLine(log),
                                  log.string()));
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count(),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

std::string findProgram(const std::string& given, const std::string& name) {
  if (!given.empty()) {
    if (!canRun(given)) throw core::UsageError(given + " is no program that can be run");
    return fs::absolute(given).string();
  }
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  if (canRun(beside)) return beside.string();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (canRun(fs::path(folder) / name)) return (fs::path(folder) / name).string();
  throw core::UsageError(fmt::format(
      "{} is neither beside this program nor on PATH: build or install all of Ariadne", name));
}

}  // namespace ariadne::compare_app
