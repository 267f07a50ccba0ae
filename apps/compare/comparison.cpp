#include "comparison.h"

#include <algorithm>
#include <limits>

#include "ariadne/core/error.h"

namespace ariadne::compare_app {

Spread spreadOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {(values[(n - 1) / 2] + values[n / 2]) / 2, values.front(), values.back()};
}

double ComparedFigure::ratio() const {
  const double below = spreadOf(stock).median;
  return below == 0 ? std::numeric_limits<double>::quiet_NaN() : spreadOf(ours).median / below;
}

std::vector<std::string> valueNames(const std::vector<FigureKind>& kinds) {
  std::vector<std::string> names;
  for (const FigureKind& k : kinds)
    for (const std::string& name : {k.stem + "_ratio", "ours_" + k.name(), "stock_" + k.name()})
      names.push_back(name);
  return names;
}

double valueOf(const Comparison& comparison, const std::string& name) {
  for (const ComparedFigure& f : comparison.figures) {
    if (name == f.kind.stem + "_ratio") return f.ratio();
    if (name == "ours_" + f.kind.name()) return spreadOf(f.ours).median;
    if (name == "stock_" + f.kind.name()) return spreadOf(f.stock).median;
  }
  throw core::UsageError("there is no figure " + name);
}

}  // namespace ariadne::compare_app
