#include "ariadne/process/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "arguments.h"
#include "ariadne/core/error.h"

namespace ariadne::process {
namespace {

using Clock = std::chrono::steady_clock;

/// Of stderr the last this many bytes are kept.
constexpr std::size_t kTail = 4000;

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

[[noreturn]] void tellAndExit() {
  const char* reason = std::strerror(errno);
  const ssize_t ignored = ::write(2, reason, std::strlen(reason));
  ::_exit(ignored < 0 ? 126 : 127);
}

/// Between fork and exec: only what is safe there.
[[noreturn]] void become(char* const* argv, const char* out, int err, pid_t parent) {
  ::setpgid(0, 0);
  // A runner that is killed with -9 takes its runs along: nothing else would stop them.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  ::dup2(err, 2);
  const int in = ::open("/dev/null", O_RDONLY);
  const int to = ::open(out, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0666);
  if (to < 0) tellAndExit();
  ::dup2(in, 0);
  ::dup2(to, 1);
  if (in > 2) ::close(in);
  if (to > 2) ::close(to);
  ::execv(argv[0], argv);
  tellAndExit();
}

}  // namespace

Process::Process(const std::vector<std::string>& argv, const std::filesystem::path& stdout_file)
    : start_(Clock::now()) {
  const auto pointers = pointersTo(argv);
  const std::string out = stdout_file.empty() ? "/dev/null" : stdout_file.string();
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw core::Error(fmt::format("cannot start {}: {}", argv[0], std::strerror(errno)));
  const pid_t parent = ::getpid();
  // Not vfork or posix_spawn: the child's peak would then begin at all of this process's memory.
  pid_ = ::fork();
  if (pid_ == 0) become(pointers.data(), out.c_str(), ends[1], parent);
  const int problem = errno;
  ::close(ends[1]);
  pipe_ = ends[0];
  if (pid_ < 0) {
    ::close(pipe_);
    throw core::Error(fmt::format("cannot start {}: {}", argv[0], std::strerror(problem)));
  }
  ::setpgid(pid_, pid_);  // also here: kill() may come before the child gets to it
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
  end_ = static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0));  // no wrapper before glibc 2.37
}

Process::Process(Process&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      end_(std::exchange(other.end_, -1)),
      start_(other.start_),
      tail_(std::move(other.tail_)) {}

Process::~Process() {
  stop();
  if (pipe_ >= 0) ::close(pipe_);
  if (end_ >= 0) ::close(end_);
}

void Process::kill() {
  if (pid_ > 0) ::kill(-pid_, SIGKILL);
}

void Process::stop() {
  if (pid_ <= 0) return;
  kill();
  ::waitpid(std::exchange(pid_, -1), nullptr, 0);
}

double Process::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void waitForAny(const std::vector<const Process*>& processes, std::chrono::milliseconds longest) {
  std::vector<pollfd> waited;
  for (const Process* p : processes)
    for (const int fd : {p->pipe_, p->end_})
      if (fd >= 0) waited.push_back({fd, POLLIN, 0});
  ::poll(waited.data(), waited.size(), static_cast<int>(longest.count()));
}

void Process::drain() {
  char block[1 << 14];
  // Bounded, so that one that never stops talking does not hold up the others.
  for (int round = 0; pipe_ >= 0 && round < 16; ++round) {
    const ssize_t got = ::read(pipe_, block, sizeof(block));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return;
    if (got == 0) {
      ::close(std::exchange(pipe_, -1));
      return;
    }
    tail_.append(block, static_cast<std::size_t>(got));
    if (tail_.size() > kTail) tail_.erase(0, tail_.size() - kTail);
  }
}

std::optional<ProcessEnd> Process::poll() {
  drain();
  if (pid_ <= 0) return std::nullopt;
  siginfo_t info{};
  if (::waitid(P_PID, pid_, &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != pid_)
    return std::nullopt;
  kill();  // what it left running in its group, while the group's number is still its own
  int status = 0;
  rusage usage{};
  ::wait4(pid_, &status, 0, &usage);
  ProcessEnd end;
  end.wall_s = elapsed_s();
  end.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.memory_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.exit_code = WEXITSTATUS(status);
  pid_ = -1;
  drain();
  end.last_words = std::move(tail_);
  return end;
}

ProcessEnd endOf(Process& process, double limit_s, const std::string& what) {
  for (;;) {
    if (auto end = process.poll()) return *end;
    if (process.elapsed_s() > limit_s)
      throw core::Error(fmt::format("{} did not end in {} s", what, limit_s));
    waitForAny({&process}, std::chrono::milliseconds(100));
  }
}

std::string describe(const ProcessEnd& end) {
  if (end.signal != 0)
    return fmt::format("killed by signal {} ({})", end.signal, ::strsignal(end.signal));
  return fmt::format("exit code {}", end.exit_code);
}

}  // namespace ariadne::process
