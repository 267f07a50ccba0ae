#include "plot_axis.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ariadne/core/numbers.h"

namespace ariadne::batch {
namespace {

using Values = std::vector<std::string>;

std::optional<double> numberOf(const std::string& text) {
  const auto number = core::parseNumber(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// In the plan's order.
Values valuesOf(const std::vector<Cell>& cells, std::size_t factor) {
  Values values;
  for (const Cell& c : cells)
    if (std::find(values.begin(), values.end(), c.values[factor]) == values.end())
      values.push_back(c.values[factor]);
  return values;
}

/// A single number needs no axis of numbers.
bool areNumbers(const Values& values) {
  return values.size() > 1 && std::all_of(values.begin(), values.end(),
                                          [](const std::string& v) { return numberOf(v); });
}

std::optional<std::size_t> factorOf(const Plan& plan, const std::vector<Cell>& cells) {
  for (std::size_t i = 0; i < plan.factors.size(); ++i)
    if (plan.factors[i] == plan.plots.over) return i;
  for (std::size_t i = 0; i < plan.factors.size(); ++i)
    if (areNumbers(valuesOf(cells, i))) return i;
  return plan.factors.empty() ? std::nullopt : std::optional<std::size_t>(0);
}

}  // namespace

std::size_t PlotAxis::placeOf(const Cell& cell) const {
  if (!factor) return cell.arm;
  return static_cast<std::size_t>(std::find(places.begin(), places.end(), cell.values[*factor]) -
                                  places.begin());
}

PlotAxis axisOf(const Plan& plan, const std::vector<Cell>& cells) {
  PlotAxis axis;
  axis.factor = factorOf(plan, cells);
  if (!axis.factor) {
    for (const PlannedArm& arm : plan.arms) axis.places.push_back(arm.name);
    return axis;
  }
  axis.places = valuesOf(cells, *axis.factor);
  if (!areNumbers(axis.places)) return axis;
  std::stable_sort(
      axis.places.begin(), axis.places.end(),
      [](const std::string& a, const std::string& b) { return *numberOf(a) < *numberOf(b); });
  for (const std::string& place : axis.places) axis.numbers.push_back(*numberOf(place));
  return axis;
}

std::vector<Panel> panelsOf(const Plan& plan, const std::vector<Cell>& cells,
                            const PlotAxis& axis) {
  std::vector<Panel> panels;
  std::map<Values, std::size_t> known;
  for (const Cell& cell : cells) {
    Panel panel;
    for (std::size_t i = 0; i < plan.factors.size(); ++i) {
      if (i == axis.factor) continue;
      panel.text += (panel.text.empty() ? "" : ", ") + plan.factors[i] + " " + cell.values[i];
      panel.values.push_back(cell.values[i]);
    }
    const auto [at, is_new] = known.emplace(panel.values, panels.size());
    if (is_new) panels.push_back(std::move(panel));
    panels[at->second].cells.push_back(&cell);
  }
  for (Panel& panel : panels)
    std::stable_sort(panel.cells.begin(), panel.cells.end(), [&](const Cell* a, const Cell* b) {
      return axis.placeOf(*a) < axis.placeOf(*b);
    });
  return panels;
}

}  // namespace ariadne::batch
