#include "plot_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "ariadne/charts/gnuplot_text.h"
#include "plot_axes.h"

namespace ariadne::batch {
namespace {

/// Filled circle, square, triangle, diamond; one more or less than colours, so that pairs differ.
constexpr int kMarks[] = {7, 5, 9, 13, 11, 15};

bool hasLegend(const Plot& plot) { return !plot.factor.empty() && plot.series.size() > 1; }

/// Arms beside each other, or points with their intervals would hide one another.
double dodgeOf(const Plot& plot, std::size_t series) {
  if (plot.factor.empty() || plot.series.size() < 2) return 0;
  const auto count = static_cast<double>(plot.series.size());
  const double share = (static_cast<double>(series) - (count - 1) / 2) / count;
  if (!isUpright(plot)) return 0.6 * share;
  double gap = plot.numbers.back() - plot.numbers.front();
  const double span = gap;
  for (std::size_t i = 1; i < plot.numbers.size(); ++i)
    gap = std::min(gap, plot.numbers[i] - plot.numbers[i - 1]);
  return share * std::min(0.5 * gap, 0.018 * count * span);
}

/// `$d0 << EOD`: a block for every series; a blank line breaks its line where a place is missing.
std::string dataOf(const Plot& plot) {
  std::string text;
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    text += fmt::format("$d{} << EOD\n", s);
    std::size_t next = 0;
    for (const PlotPoint& p : plot.series[s].points) {
      if (p.place > next && next > 0) text += "\n";
      next = p.place + 1;
      const double along = dodgeOf(plot, s) +
                           (isUpright(plot) ? plot.numbers[p.place] : static_cast<double>(p.place));
      text += isUpright(plot) ? fmt::format("{:.10g} {:.10g}", along, p.value)
                              : fmt::format("{:.10g} {:.10g}", p.value, along);
      text += fmt::format(" {:.10g} {:.10g}\n", p.low, p.high);
    }
    text += "EOD\n";
  }
  return text;
}

std::string curvesOf(const Plot& plot) {
  std::string text = "plot ";
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    if (plot.series[s].points.empty()) continue;
    text += fmt::format(
        "{}$d{} using 1:2:3:4 with {} lc rgb '{}' pt {} title {}", text == "plot " ? "" : ", ", s,
        isUpright(plot) ? "yerrorlines" : "xerrorbars", charts::colourOf(s),
        kMarks[s % std::size(kMarks)],
        hasLegend(plot) ? charts::inQuotes(charts::shortened(plot.series[s].name)) : "''");
  }
  return text + "\n";
}

int heightOf(const Plot& plot) {
  if (isUpright(plot)) return 400;
  const std::size_t rows = plot.places.size() * (plot.factor.empty() ? 1 : plot.series.size());
  return static_cast<int>(std::clamp<std::size_t>(120 + 26 * rows, 200, 6000));
}

std::string scriptOf(const Plot& plot, const std::filesystem::path& folder) {
  const int width = widthOf(plot);
  const int height = heightOf(plot);
  std::string text = "reset\n" + dataOf(plot) +
                     "set border 3\nset tics nomirror out\n"
                     "set grid xtics ytics lc rgb '#b4b4b4' lw 0.5 dt 1\n"
                     "set bars 0.6\nset key outside above center horizontal Left reverse\n" +
                     axesOf(plot);
  if (!plot.panel.empty()) text += "set title " + charts::inQuotes(plot.panel) + "\n";
  const auto output = [&](const char* end) {
    return "set output " + charts::inQuotes((folder / (plot.name + end)).string()) + "\n";
  };
  // An SVG is named so that the parts of several may stand on one page.
  text += fmt::format(
      "set terminal svg size {},{} fixed font 'sans-serif,14' linewidth 1.4 noenhanced "
      "background '#ffffff' name {}\n",
      width, height, charts::inQuotes(plot.name));
  text += output(".svg") + curvesOf(plot);
  text += fmt::format(
      "set terminal pngcairo size {},{} font 'sans,11' fontscale 2 linewidth 2.4 pointscale 2 "
      "noenhanced background '#ffffff'\n",
      2 * width, 2 * height);
  return text + output(".png") + "replot\nunset output\n";
}

}  // namespace

std::string gnuplotScript(const std::vector<Plot>& plots, const std::filesystem::path& folder) {
  std::string text;
  for (const Plot& plot : plots) text += scriptOf(plot, folder);
  return text;
}

}  // namespace ariadne::batch
