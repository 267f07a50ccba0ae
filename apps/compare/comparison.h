// The figures of all repeats, ours and stock's.
#pragma once
#include <string>
#include <vector>

#include "figures.h"

namespace ariadne::compare_app {

/// Of one figure over the repeats.
struct Spread {
  double median = 0;
  double low = 0;
  double high = 0;
};

/// @param values at least one
Spread spreadOf(std::vector<double> values);

struct ComparedFigure {
  FigureKind kind;
  std::vector<double> ours;  ///< one a repeat
  std::vector<double> stock;
  /// Median of ours over median of stock's; nan when that is 0.
  double ratio() const;
};

struct Comparison {
  std::string dataset;
  std::string stock_base;  ///< INI of stock's other settings
  std::string settings;    ///< those that both share, as a sentence
  std::vector<ComparedFigure> figures;
};

/// All names that valueOf() takes: ours_NAME, stock_NAME, STEM_ratio.
std::vector<std::string> valueNames(const std::vector<FigureKind>& kinds);

/// A median, or a ratio of medians. @param name one of valueNames()
double valueOf(const Comparison& comparison, const std::string& name);

}  // namespace ariadne::compare_app
