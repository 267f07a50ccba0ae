// Which plots an experiment's INI asks for: [plots].
#pragma once
#include <string>
#include <vector>

namespace ariadne::batch {

/// What the rate of successes is called where figures are named.
inline constexpr const char* kSuccessPlot = "success";

/// Section [plots] of an experiment: which figures are drawn, over what.
struct PlotChoice {
  std::vector<std::string> figures = {"all"};  ///< or "none", or of [figures] names and "success"
  std::string over;  ///< factor along the axis; empty: the first one of numbers, else the first

  /// Whether this figure is drawn.
  bool has(const std::string& figure) const;
};

/// Throws core::UsageError naming `file` and the key for a figure or factor that is not known.
void checkPlots(const PlotChoice& plots, const std::vector<std::string>& figures,
                const std::vector<std::string>& factors, const std::string& file);

}  // namespace ariadne::batch
