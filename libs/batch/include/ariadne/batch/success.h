// When a run counts as a success, by its figures.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/io/ini_text.h"

namespace ariadne::batch {

/// Figures of a run by name, as `costs.cpu_s`; true is 1. NaN: the program says that this run has
/// none (null in its summary.json).
using Figures = std::map<std::string, double>;

/// Nothing for a figure that is not there or NaN.
std::optional<double> valueOf(const Figures& figures, const std::string& name);

/// What a run came to by the experiment's condition.
enum class Judgement {
  success,
  no_success,
  unjudged  ///< the figure is NaN: there was nothing to judge this run by
};

/// One figure against a bound: "correct" (not 0), "ate_rmse_m <= 0.5".
struct Success {
  std::string figure;  ///< empty: nothing is judged
  std::string relation = "!=";
  double bound = 0;

  /// A run without the figure is no success.
  Judgement of(const Figures& figures) const;
  /// The condition: "ate_rmse_m < 0.5", or a figure alone that is to be true.
  std::string text() const;
};

/// Throws core::UsageError naming the entry's place when its value is no such condition.
Success parseSuccess(const io::IniEntry& entry);

/// Words between commas (or blanks), trimmed; empty ones are left out.
std::vector<std::string> splitList(const std::string& text, const char* separators);

}  // namespace ariadne::batch
