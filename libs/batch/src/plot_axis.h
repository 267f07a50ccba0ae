// The axis of an experiment's plots, and which cells share a plot.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/tables.h"

namespace ariadne::batch {

struct PlotAxis {
  std::optional<std::size_t> factor;  ///< in Plan::factors; nothing: arms are the places
  std::vector<std::string> places;
  std::vector<double> numbers;  ///< see Plot

  std::size_t placeOf(const Cell& cell) const;
};

PlotAxis axisOf(const Plan& plan, const std::vector<Cell>& cells);

/// Cells that differ in arm and place only.
struct Panel {
  std::string text;                 ///< "world nested, noise 2"
  std::vector<std::string> values;  ///< of the other factors
  std::vector<const Cell*> cells;   ///< by place
};

std::vector<Panel> panelsOf(const Plan& plan, const std::vector<Cell>& cells, const PlotAxis& axis);

}  // namespace ariadne::batch
