#include "progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace ariadne::slam_app {
namespace {

using Clock = std::chrono::steady_clock;

std::string minutes(double seconds) {
  const auto s = std::lround(std::clamp(seconds, 0.0, 1e9));
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace

std::string progressLine(double fraction, std::size_t scans, double elapsed_s, double neff,
                         std::size_t particles) {
  const double share = std::clamp(fraction, 0.0, 1.0);
  const double rate = elapsed_s > 0 ? static_cast<double>(scans) / elapsed_s : 0;
  std::string line = fmt::format("{:3.0f} %  {} scans  {:.0f} scans/s  Neff {:.1f} of {}",
                                 100 * share, scans, rate, neff, particles);
  // Before 1 % is read an estimate would be noise.
  if (share > 0.01) line += fmt::format("  {} left", minutes(elapsed_s * (1 - share) / share));
  return line;
}

Progress::Progress(std::ostream& out, ProgressStyle style)
    : out_(out), style_(style), start_(Clock::now()), last_(start_) {}

bool Progress::due() const {
  if (style_ == ProgressStyle::none) return false;
  const auto pause = style_ == ProgressStyle::terminal ? std::chrono::milliseconds(200)
                                                       : std::chrono::milliseconds(5000);
  return Clock::now() - last_ >= pause;
}

void Progress::update(double fraction, std::size_t scans, double neff, std::size_t particles) {
  if (!due()) return;
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  show(progressLine(fraction, scans, elapsed_s, neff, particles));
}

void Progress::show(const std::string& line) {
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

}  // namespace ariadne::slam_app
