// Lets records pass in order of time. One wrong stamp far in the future must not cost everything
// after it, so a record waits until two more have been seen: when both are in order with what
// passed before and it is later than both, it is the wrong one.
#pragma once
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

namespace ariadne::io {

template <class Record>
class TimeGate {
 public:
  void push(double time_s, Record record) { waiting_.emplace_back(time_s, std::move(record)); }
  /// Nothing more will come: the records that wait may pass.
  void finish() { finished_ = true; }
  /// The next record in order, if it may pass already.
  std::optional<std::pair<double, Record>> pop() {
    while (waiting_.size() >= 3 || (finished_ && !waiting_.empty())) {
      auto front = std::move(waiting_.front());
      waiting_.pop_front();
      if (!inOrder(front.first)) {
        ++rejected_;
        continue;
      }
      passed_ = front.first;
      return front;
    }
    return std::nullopt;
  }
  std::size_t rejected() const { return rejected_; }

 private:
  bool inOrder(double time_s) const {
    if (!(time_s >= passed_)) return false;
    if (waiting_.size() < 2) return true;
    const double next = waiting_[0].first, after = waiting_[1].first;
    return !(next >= passed_ && after >= next && after < time_s);
  }
  std::deque<std::pair<double, Record>> waiting_;
  double passed_ = -std::numeric_limits<double>::infinity();
  bool finished_ = false;
  std::size_t rejected_ = 0;
};

}  // namespace ariadne::io
