// How far the run is: one line rewritten on a terminal, a line every few seconds elsewhere.
#pragma once
#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace ariadne::slam_app {

enum class ProgressStyle { none, lines, terminal };

class Progress {
 public:
  Progress(std::ostream& out, ProgressStyle style);
  /// Whether it is time for another line.
  bool due() const;
  void show(const std::string& line);
  /// Shows progressLine() when it is time. @param fraction of the dataset that was read, 0 to 1.
  void update(double fraction, std::size_t scans, double neff, std::size_t particles);
  /// Ends the terminal's line; later updates start a new one.
  void finish();

 private:
  std::ostream& out_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_;
  std::size_t line_length_ = 0;
};

/// "  45 %  1234 scans  310 scans/s  Neff 23.1 of 30  0:12 left".
std::string progressLine(double fraction, std::size_t scans, double elapsed_s, double neff,
                         std::size_t particles);

}  // namespace ariadne::slam_app
