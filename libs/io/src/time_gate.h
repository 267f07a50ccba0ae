// Lets records pass in the file's order while their stamps make sense. A record waits until two
// more have been seen, since only what follows tells one wrong stamp from a clock that was set:
//   ahead of the next two, which go on from what passed   one wrong stamp: this record is dropped
//   behind what passed, and the next two go on from it,
//   behind what passed too                                the clock was set back: all of them pass
//   behind what passed otherwise                          out of order: this record is dropped
#pragma once
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "ariadne/io/dataset.h"

namespace ariadne::io {

template <class Record>
class TimeGate {
 public:
  void push(double time_s, Record record) { waiting_.emplace_back(time_s, std::move(record)); }
  /// Nothing more will come: the records that wait may pass.
  void finish() { finished_ = true; }
  /// The next record that makes sense, if it may pass already.
  std::optional<std::pair<double, Record>> pop() {
    while (waiting_.size() >= 3 || (finished_ && !waiting_.empty())) {
      auto front = std::move(waiting_.front());
      waiting_.pop_front();
      const bool set_back = clockWasSetBack(front.first);
      if (!set_back && !inOrder(front.first)) {
        ++rejected_;
        continue;
      }
      if (set_back && set_backs_.count++ == 0) {
        set_backs_.from_s = passed_;
        set_backs_.to_s = front.first;
      }
      passed_ = front.first;
      return front;
    }
    return std::nullopt;
  }
  std::size_t rejected() const { return rejected_; }
  const ClockSetBacks& setBacks() const { return set_backs_; }

 private:
  bool inOrder(double time_s) const {
    if (!(time_s >= passed_)) return false;
    if (waiting_.size() < 2) return true;
    const double next = waiting_[0].first, after = waiting_[1].first;
    return !(next >= passed_ && after >= next && after < time_s);
  }
  bool clockWasSetBack(double time_s) const {
    if (waiting_.empty() || !(time_s < passed_)) return false;
    const double next = waiting_[0].first;
    const double after = waiting_.size() > 1 ? waiting_[1].first : next;
    return next >= time_s && next < passed_ && after >= next;
  }
  std::deque<std::pair<double, Record>> waiting_;
  double passed_ = -std::numeric_limits<double>::infinity();
  bool finished_ = false;
  std::size_t rejected_ = 0;
  ClockSetBacks set_backs_;
};

}  // namespace ariadne::io
