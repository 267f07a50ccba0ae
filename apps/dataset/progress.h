// How far a file was read: a line that renews itself on a terminal, a line every 10 s elsewhere,
// nothing for what takes under two seconds.
#pragma once
#include <chrono>
#include <iosfwd>
#include <string>

namespace ariadne {

class Progress {
 public:
  Progress(std::ostream& err, std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void update(double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& err_;
  std::string what_;
  bool terminal_;
  Clock::time_point begin_;
  Clock::time_point next_;
  bool shown_ = false;
};

}  // namespace ariadne
