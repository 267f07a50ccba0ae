#include "plot_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ariadne/charts/gnuplot_text.h"

namespace ariadne::batch {
namespace {

using charts::inQuotes;
using charts::lettersOf;
using charts::shortened;
using charts::tick;

/// The factor's values where there is room for each, else round numbers.
std::string numberTicks(const Plot& plot) {
  const double span = plot.numbers.back() - plot.numbers.front();
  for (std::size_t i = 1; i < plot.numbers.size(); ++i)
    if (plot.numbers[i] - plot.numbers[i - 1] < span / 14) return "autofreq";
  std::string ticks;
  for (std::size_t i = 0; i < plot.numbers.size(); ++i)
    ticks += (i == 0 ? "" : ", ") + tick(plot.places[i], plot.numbers[i]);
  return "(" + ticks + ")";
}

/// Five steps or fewer of 1, 2 or 5 times a power of ten: gnuplot's own ticks run into each other
/// where numbers have many digits.
std::string valueTicks(const Plot& plot) {
  if (plot.is_rate) return "20";
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (const PlotSeries& s : plot.series)
    for (const PlotPoint& p : s.points) {
      low = std::min(low, p.low);
      high = std::max(high, p.high);
    }
  if (!(high > low)) return "autofreq";
  const double rough = (high - low) / 5;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  for (const double f : {1.0, 2.0, 5.0})
    if (f * decade >= rough) return fmt::format("{:.10g}", f * decade);
  return fmt::format("{:.10g}", 10 * decade);
}

/// What names on the left take, of the letters that fonts are at most wide.
int leftOf(const Plot& plot) {
  std::size_t longest = 0;
  for (const std::string& place : plot.places)
    longest = std::max(longest, lettersOf(shortened(place)));
  return (plot.factor.empty() ? 30 : 50) + 8 * static_cast<int>(longest);
}

/// gnuplot would leave much more than names take, and with that set put its own label beside it.
std::string leftSide(const Plot& plot) {
  const int width = widthOf(plot);
  return fmt::format(
      "set lmargin at screen {:.4g}\nset label 1 {} at screen {:.4g}, graph 0.5 center rotate\n",
      static_cast<double>(leftOf(plot)) / width, inQuotes(withUnit(plot.factor)), 16.0 / width);
}

}  // namespace

bool isUpright(const Plot& plot) { return !plot.numbers.empty(); }

int widthOf(const Plot& plot) { return isUpright(plot) ? 640 : std::max(640, leftOf(plot) + 420); }

std::string axesOf(const Plot& plot) {
  const char* value_axis = isUpright(plot) ? "y" : "x";
  std::string text = fmt::format("set {0}label {1}\nset {0}tics {2}\n", value_axis,
                                 inQuotes(plot.figure), valueTicks(plot));
  if (plot.is_rate) text += fmt::format("set {}range [-2:102]\n", value_axis);
  if (isUpright(plot)) {
    const double margin = 0.06 * (plot.numbers.back() - plot.numbers.front());
    return text +
           fmt::format("set xlabel {}\nset xtics {}\nset xrange [{:.10g}:{:.10g}]\n",
                       inQuotes(withUnit(plot.factor)), numberTicks(plot),
                       plot.numbers.front() - margin, plot.numbers.back() + margin) +
           (plot.is_rate ? "" : "set offsets 0, 0, graph 0.05, graph 0.05\n");
  }
  std::string ticks;
  for (std::size_t i = 0; i < plot.places.size(); ++i)
    ticks += (i == 0 ? "" : ", ") + tick(plot.places[i], static_cast<double>(i));
  return text +
         fmt::format("set ytics ({})\nset yrange [{}:-0.5]\n", ticks,
                     static_cast<double>(plot.places.size()) - 0.5) +
         (plot.is_rate ? "" : "set offsets graph 0.05, graph 0.05, 0, 0\n") + leftSide(plot);
}

}  // namespace ariadne::batch
