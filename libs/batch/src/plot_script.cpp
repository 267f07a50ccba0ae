#include "plot_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace ariadne::batch {
namespace {

/// Okabe and Ito's colours, told apart by the colour-blind too; without black, the axes' colour,
/// and yellow, which is hard to see on white.
constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                    "#E69F00", "#56B4E9", "#808080"};
/// Filled circle, square, triangle, diamond; one more or less than colours, so that pairs differ.
constexpr int kMarks[] = {7, 5, 9, 13, 11, 15};

/// Numbers are drawn upright with lines between them; names lie, so that long ones have room.
bool isUpright(const Plot& plot) { return !plot.numbers.empty(); }

bool hasLegend(const Plot& plot) { return !plot.factor.empty() && plot.series.size() > 1; }

/// UTF-8's later bytes.
bool isInside(char c) { return (c & 0xC0) == 0x80; }

std::size_t lettersOf(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isInside));
}

/// Cut where it would take the room of the plot; tables have the whole name.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 36;
  if (lettersOf(text) <= kMost) return text;
  std::size_t end = 0;
  for (std::size_t letters = 0; letters < kMost; ++letters) do
      ++end;
    while (isInside(text[end]));
  return text.substr(0, end) + "…";
}

/// In single quotes nothing but themselves means anything to gnuplot.
std::string inQuotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

/// A tick's label, in which % would begin a format.
std::string tick(const std::string& label, double at) {
  std::string text;
  for (const char c : shortened(label)) text += c == '%' ? "%%" : std::string(1, c);
  return fmt::format("{} {:.10g}", inQuotes(text), at);
}

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

std::string axesOf(const Plot& plot) {
  const char* value_axis = isUpright(plot) ? "y" : "x";
  std::string text = fmt::format("set {0}label {1}\nset {0}tics {2}\n", value_axis,
                                 inQuotes(plot.figure), valueTicks(plot));
  if (plot.is_rate) text += fmt::format("set {}range [0:100]\n", value_axis);
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
         (plot.is_rate ? "" : "set offsets graph 0.05, graph 0.05, 0, 0\n");
}

std::string curvesOf(const Plot& plot) {
  std::string text = "plot ";
  for (std::size_t s = 0; s < plot.series.size(); ++s) {
    if (plot.series[s].points.empty()) continue;
    text +=
        fmt::format("{}$d{} using 1:2:3:4 with {} lc rgb '{}' pt {} title {}",
                    text == "plot " ? "" : ", ", s, isUpright(plot) ? "yerrorlines" : "xerrorbars",
                    kColours[s % std::size(kColours)], kMarks[s % std::size(kMarks)],
                    hasLegend(plot) ? inQuotes(shortened(plot.series[s].name)) : "''");
  }
  return text + "\n";
}

/// What names on the left take, of the letters that fonts are at most wide.
int leftOf(const Plot& plot) {
  std::size_t longest = 0;
  for (const std::string& place : plot.places)
    longest = std::max(longest, lettersOf(shortened(place)));
  return (plot.factor.empty() ? 30 : 50) + 8 * static_cast<int>(longest);
}

/// gnuplot would leave much more than names take, and with that set put its own label beside it.
std::string leftSide(const Plot& plot, int width) {
  return fmt::format(
      "set lmargin at screen {:.4g}\nset label 1 {} at screen {:.4g}, graph 0.5 center rotate\n",
      static_cast<double>(leftOf(plot)) / width, inQuotes(withUnit(plot.factor)), 16.0 / width);
}

int heightOf(const Plot& plot) {
  if (isUpright(plot)) return 400;
  const std::size_t rows = plot.places.size() * (plot.factor.empty() ? 1 : plot.series.size());
  return static_cast<int>(std::clamp<std::size_t>(120 + 26 * rows, 200, 6000));
}

std::string scriptOf(const Plot& plot, const std::filesystem::path& folder) {
  const int width = isUpright(plot) ? 640 : std::max(640, leftOf(plot) + 420);
  const int height = heightOf(plot);
  std::string text = "reset\n" + dataOf(plot) +
                     "set border 3\nset tics nomirror out\n"
                     "set grid xtics ytics lc rgb '#b4b4b4' lw 0.5 dt 1\n"
                     "set bars 0.6\nset key outside above center horizontal Left reverse\n" +
                     axesOf(plot);
  if (!isUpright(plot)) text += leftSide(plot, width);
  if (!plot.panel.empty()) text += "set title " + inQuotes(plot.panel) + "\n";
  const auto output = [&](const char* end) {
    return "set output " + inQuotes((folder / (plot.name + end)).string()) + "\n";
  };
  // An SVG is named so that the parts of several may stand on one page.
  text += fmt::format(
      "set terminal svg size {},{} fixed font 'sans-serif,14' linewidth 1.4 noenhanced "
      "background '#ffffff' name {}\n",
      width, height, inQuotes(plot.name));
  text += output(".svg") + curvesOf(plot);
  text += fmt::format(
      "set terminal pngcairo size {},{} font 'sans,11' fontscale 2 linewidth 2.4 pointscale 2 "
      "noenhanced background '#ffffff'\n",
      2 * width, 2 * height);
  return text + output(".png") + "replot\nunset output\n";
}

}  // namespace

std::string gnuplotScript(const std::vector<Plot>& plots, const std::filesystem::path& folder) {
  std::string text = "set encoding utf8\n";
  for (const Plot& plot : plots) text += scriptOf(plot, folder);
  return text;
}

}  // namespace ariadne::batch
