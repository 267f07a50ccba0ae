#include "ariadne/batch/plot_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"

namespace ariadne::batch {
namespace {

bool isIn(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool PlotChoice::has(const std::string& figure) const {
  return isIn(figures, "all") || isIn(figures, figure);
}

void checkPlots(const PlotChoice& plots, const std::vector<std::string>& figures,
                const std::vector<std::string>& factors, const std::string& file) {
  std::vector<std::string> known = {"all", "none", kSuccessPlot};
  known.insert(known.end(), figures.begin(), figures.end());
  for (const std::string& figure : plots.figures)
    if (!isIn(known, figure))
      throw core::UsageError(fmt::format("{}: [plots] figures: takes {}; \"{}\" is none of them",
                                         file, fmt::join(known, ", "), core::printable(figure)));
  if (!plots.over.empty() && !isIn(factors, plots.over))
    throw core::UsageError(fmt::format("{}: [plots] over = {}: there is no [factor.{}]", file,
                                       core::printable(plots.over), core::printable(plots.over)));
}

}  // namespace ariadne::batch
