// Where in a log the filter will be updated: the costs of both programs grow with their updates.
#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "config.h"

namespace ariadne::compare_app {

class LogUpdates {
 public:
  /// Reads all of the log. Throws core::Error when it cannot.
  explicit LogUpdates(const slam_app::SlamConfig& config);
  std::size_t count() const { return shares_.size(); }
  /// The log's share, 0 to 1, that was read when an update comes (from 0).
  double shareOfLog(std::size_t update) const { return shares_.at(update); }
  /// The share of all updates that come in this share of the log.
  double shareOfUpdates(double share_of_log) const;

 private:
  std::vector<double> shares_;
};

}  // namespace ariadne::compare_app
