// What the results of an experiment come to.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/run_result.h"
#include "ariadne/batch/text_table.h"

namespace ariadne::batch {

/// Seeds on which both arms were judged, by which of them was a success.
struct Pairs {
  std::size_t only_first = 0;  ///< the experiment's first arm
  std::size_t only_this = 0;
  double p = 1;       ///< McNemar's exact
  double p_holm = 1;  ///< adjusted for all pairs of the table
};

/// An arm at one combination of the factors' values.
struct Cell {
  std::vector<std::string> values;
  std::size_t arm = 0;
  std::size_t planned = 0;
  std::size_t finished = 0;  ///< with figures
  std::size_t failed = 0;    ///< without: crashed, hung, killed
  std::size_t unjudged = 0;  ///< of the finished: neither success nor failure of one
  std::size_t successes = 0;
  std::vector<std::vector<double>> samples;    ///< of Plan::figures, of the runs that have it
  std::vector<std::optional<double>> medians;  ///< of those
  /// Of Plan::relative: in per cent of the first arm's figure on the same seed and values; of the
  /// seeds that have both and where that is not 0. Not of the first arm.
  std::vector<std::vector<double>> changes;
  std::optional<Pairs> pairs;  ///< not of the first arm

  /// Finished runs of which success could be told.
  std::size_t judged() const { return finished - unjudged; }
};

/// Nothing of no values.
std::optional<double> medianOf(std::vector<double> values);

/// In the plan's order, so that it does not matter in which order runs were finished.
/// Throws core::UsageError for a figure that no finished run has, naming the nearest that there is.
std::vector<Cell> cellsOf(const Plan& plan, const std::map<std::string, RunResult>& results);

/// Depends on the plan and the figures only.
TextTable tableOf(const Plan& plan, const std::vector<Cell>& cells, TableFormat format);

}  // namespace ariadne::batch
