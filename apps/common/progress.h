// How far a program is: one line rewritten on a terminal, a line every few seconds elsewhere.
#pragma once
#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace ariadne::app {

enum class ProgressStyle { none, lines, terminal };

/// A line rewritten where `err` is the terminal.
ProgressStyle progressStyle(bool quiet, const std::ostream& err);

class Progress {
 public:
  Progress(std::ostream& out, ProgressStyle style);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Whether it is time for another line.
  bool due() const;
  void show(const std::string& line);
  /// Shows "WHAT: 45 %, 0:12 left" when it is time. @param share of the work that is done, 0 to 1.
  void tell(const std::string& what, double share);
  /// Ends the terminal's line; later updates start a new one.
  void finish();
  double elapsed_s() const;

 private:
  std::ostream& out_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
  std::size_t line_length_ = 0;
};

/// "1:05", "2:00:03".
std::string timeText(double seconds);

/// "0:12 left"; empty before a hundredth is done, when an estimate would be noise.
std::string timeLeft(double share, double elapsed_s);

}  // namespace ariadne::app
