#include "ariadne/process/call.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>

#include "arguments.h"
#include "ariadne/core/error.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/find_program.h"
#include "ariadne/process/process.h"

namespace ariadne::process {
namespace {

std::string trimmedEnd(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

/// As system(3) does: the terminal's signals are the program's that is waited for.
struct TerminalSignalsIgnored {
  struct sigaction before_int {
  }, before_quit{};
  TerminalSignalsIgnored() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGINT, &ignore, &before_int);
    ::sigaction(SIGQUIT, &ignore, &before_quit);
  }
  ~TerminalSignalsIgnored() {
    ::sigaction(SIGINT, &before_int, nullptr);
    ::sigaction(SIGQUIT, &before_quit, nullptr);
  }
};

}  // namespace

CallResult call(std::vector<std::string> argv, double limit_s) {
  CallResult result;
  const std::string name = argv[0];
  argv[0] = findInPath(name).string();
  if ((result.missing = argv[0].empty())) return result;
  const io::ScratchFolder scratch("called");
  const std::filesystem::path printed = scratch.path() / "stdout";
  Process process(argv, printed);
  std::optional<ProcessEnd> end;
  while (!(end = process.poll())) {
    if (process.elapsed_s() > limit_s) {
      result.error = fmt::format("no answer in {} s", limit_s);
      return result;
    }
    waitForAny({&process}, std::chrono::milliseconds(100));
  }
  result.ok = end->signal == 0 && end->exit_code == 0;
  result.out = io::readWhole(printed);
  result.error = trimmedEnd(end->last_words);
  if (!result.ok && result.error.empty()) result.error = describe(*end);
  return result;
}

void callInForeground(const std::vector<std::string>& argv) {
  const auto pointers = pointersTo(argv);
  const pid_t parent = ::getpid();
  const pid_t pid = ::fork();
  if (pid < 0) throw core::Error(fmt::format("cannot start {}: {}", argv[0], std::strerror(errno)));
  if (pid == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // it is not to go on alone
    if (::getppid() != parent) ::_exit(127);
    ::execvp(pointers[0], pointers.data());
    ::_exit(127);
  }
  const TerminalSignalsIgnored ignored;
  while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

ProcessEnd runToEnd(const std::vector<std::string>& argv, const std::filesystem::path& stdout_file,
                    const std::function<void(const Process&)>& meanwhile) {
  Process process(argv, stdout_file);
  std::optional<ProcessEnd> end;
  while (!(end = process.poll())) {
    if (meanwhile) meanwhile(process);
    waitForAny({&process}, std::chrono::milliseconds(100));
  }
  if (end->signal == 0 && end->exit_code == 0) return *end;
  throw core::Error(
      fmt::format("{} {} {}: {}", argv[0], end->signal != 0 ? "was" : "failed with", describe(*end),
                  end->last_words.empty() ? "it said nothing" : trimmedEnd(end->last_words)));
}

}  // namespace ariadne::process
