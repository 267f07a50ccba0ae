#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <utility>

namespace ariadne {

Progress::Progress(std::ostream& err, std::string what)
    : err_(err),
      what_(std::move(what)),
      terminal_(&err == &std::cerr && ::isatty(STDERR_FILENO) != 0),
      begin_(Clock::now()),
      next_(begin_ + std::chrono::seconds(2)) {}

Progress::~Progress() {
  if (shown_ && terminal_) err_ << "\r\x1b[K" << std::flush;
}

void Progress::update(double fraction) {
  const auto now = Clock::now();
  if (now < next_) return;
  next_ = now + (terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10));
  shown_ = true;
  const double passed_s = std::chrono::duration<double>(now - begin_).count();
  std::string line = fmt::format("{}: {:.0f} %", what_, 100 * fraction);
  if (fraction > 0.01)
    line += fmt::format(", {:.0f} s to go", passed_s * (1 - fraction) / fraction);
  if (terminal_) {
    err_ << '\r' << line << "\x1b[K" << std::flush;
  } else {
    err_ << "ariadne-dataset: " << line << std::endl;
  }
}

}  // namespace ariadne
