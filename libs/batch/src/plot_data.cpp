#include "ariadne/batch/plot_data.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "ariadne/statistics/interval.h"
#include "median_interval.h"
#include "plot_axis.h"

namespace ariadne::batch {
namespace {

/// Nothing when no run of the cell is known.
using PointOf = std::function<std::optional<PlotPoint>(const Cell&)>;

std::optional<PlotPoint> ratePoint(const Cell& cell) {
  if (cell.judged() == 0) return std::nullopt;
  const statistics::Interval i = statistics::wilsonInterval(cell.successes, cell.judged());
  const double rate = static_cast<double>(cell.successes) / static_cast<double>(cell.judged());
  return PlotPoint{0, 100 * rate, 100 * i.low, 100 * i.high, cell.judged()};
}

std::optional<PlotPoint> medianPoint(const Cell& cell, std::size_t figure) {
  const auto& values = cell.samples[figure];
  if (values.empty()) return std::nullopt;
  const statistics::Interval i = medianInterval95(values);
  return PlotPoint{0, *cell.medians[figure], i.low, i.high, values.size()};
}

/// Fit for a file and for gnuplot's `name`, and not another plot's.
std::string freeName(const std::string& figure, const std::vector<std::string>& values,
                     std::set<std::string>& taken) {
  std::string name = figure;
  for (const std::string& value : values) name += "_" + value;
  name = name.substr(0, 80);
  for (char& c : name) {
    const bool fits = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!fits) c = '_';
  }
  std::string numbered = name;
  for (int i = 2; !taken.insert(numbered).second; ++i) numbered = name + "_" + std::to_string(i);
  return numbered;
}

Plot plotOf(const Plan& plan, const PlotAxis& axis, const Panel& panel, const PointOf& pointOf) {
  Plot plot;
  plot.panel = panel.text;
  if (axis.factor) plot.factor = plan.factors[*axis.factor];
  plot.places = axis.places;
  plot.numbers = axis.numbers;
  for (const PlannedArm& arm : plan.arms) plot.series.push_back({arm.name, {}});
  for (const Cell* cell : panel.cells) {
    auto point = pointOf(*cell);
    if (!point) continue;
    point->place = axis.placeOf(*cell);
    plot.series[cell->arm].points.push_back(*point);
  }
  return plot;
}

bool isEmpty(const Plot& plot) {
  return std::all_of(plot.series.begin(), plot.series.end(),
                     [](const PlotSeries& s) { return s.points.empty(); });
}

}  // namespace

std::string withUnit(const std::string& figure) {
  static const std::vector<std::pair<std::string, std::string>> units = {
      {"_m", "m"},     {"_m2", "m²"},   {"_s", "s"},   {"_ms", "ms"},    {"_us", "µs"},
      {"_deg", "deg"}, {"_rad", "rad"}, {"_mb", "MB"}, {"_nats", "nats"}};
  for (const auto& [end, unit] : units)
    if (figure.size() > end.size() &&
        figure.compare(figure.size() - end.size(), end.size(), end) == 0)
      return figure.substr(0, figure.size() - end.size()) + " (" + unit + ")";
  return figure;
}

std::vector<Plot> plotsOf(const Plan& plan, const std::vector<Cell>& cells) {
  const PlotAxis axis = axisOf(plan, cells);
  const std::vector<Panel> panels = panelsOf(plan, cells, axis);
  std::vector<Plot> plots;
  std::set<std::string> taken;
  const auto add = [&](const std::string& name, const PointOf& pointOf, bool is_rate) {
    for (const Panel& panel : panels) {
      Plot plot = plotOf(plan, axis, panel, pointOf);
      plot.name = freeName(name, panel.values, taken);
      plot.is_rate = is_rate;
      plot.figure = is_rate ? "success (%)" : withUnit(name);
      plot.about = is_rate ? plan.success.text() + "; rate with Wilson's 95 % interval"
                           : "median with the bootstrap's 95 % interval";
      if (!isEmpty(plot)) plots.push_back(std::move(plot));
    }
  };
  if (!plan.success.figure.empty() && plan.plots.has(kSuccessPlot))
    add(kSuccessPlot, ratePoint, true);
  for (std::size_t i = 0; i < plan.figures.size(); ++i)
    if (plan.plots.has(plan.figures[i]))
      add(
          plan.figures[i], [i](const Cell& c) { return medianPoint(c, i); }, false);
  return plots;
}

}  // namespace ariadne::batch
