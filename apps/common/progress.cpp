#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace ariadne::app {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

ProgressStyle progressStyle(bool quiet, const std::ostream& err) {
  if (quiet) return ProgressStyle::none;
  const bool terminal = &err == &std::cerr && ::isatty(STDERR_FILENO) != 0;
  return terminal ? ProgressStyle::terminal : ProgressStyle::lines;
}

Progress::Progress(std::ostream& out, ProgressStyle style)
    : out_(out), style_(style), start_(Clock::now()), last_(start_) {}

bool Progress::due() const {
  if (style_ == ProgressStyle::none) return false;
  const auto pause = style_ == ProgressStyle::terminal ? std::chrono::milliseconds(200)
                                                       : std::chrono::milliseconds(5000);
  return Clock::now() - last_ >= pause;
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::tell(const std::string& what, double share) {
  if (!due()) return;
  const std::string left = timeLeft(share, elapsed_s());
  show(fmt::format("{}: {:.0f} %{}{}", what, 100 * share, left.empty() ? "" : ", ", left));
}

void Progress::show(const std::string& line) {
  if (style_ == ProgressStyle::none) return;
  last_ = Clock::now();
  if (style_ != ProgressStyle::terminal) {
    out_ << line << '\n' << std::flush;
    return;
  }
  const std::size_t rest = line_length_ > line.size() ? line_length_ - line.size() : 0;
  out_ << '\r' << line << std::string(rest, ' ') << std::flush;
  line_length_ = line.size();
}

void Progress::finish() {
  if (line_length_ > 0) out_ << '\n' << std::flush;
  line_length_ = 0;
}

std::string timeText(double seconds) {
  const auto s = std::lround(std::clamp(seconds, 0.0, 1e9));
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string timeLeft(double share, double elapsed_s) {
  return share > 0.01 ? timeText(elapsed_s * (1 - share) / share) + " left" : "";
}

}  // namespace ariadne::app
