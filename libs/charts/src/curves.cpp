#include "ariadne/charts/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/charts/gnuplot.h"
#include "ariadne/charts/gnuplot_text.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::charts {
namespace {

// Pixels.
constexpr double kWidth = 1000;
constexpr double kLeft = 70;
constexpr double kTop = 60;
constexpr double kPlotWidth = 900;
constexpr double kPlotHeight = 420;
constexpr double kLegendRow = 20;
constexpr std::size_t kLegendColumns = 3;

double heightOf(const CurveChart& chart) {
  const std::size_t rows = (chart.curves.size() + kLegendColumns - 1) / kLegendColumns;
  return kPlotHeight + 140 + kLegendRow * static_cast<double>(std::max<std::size_t>(rows, 1) - 1);
}

double endOfX(const CurveChart& chart) {
  double end = 0;
  for (const Curve& c : chart.curves)
    for (const double x : c.x) end = std::max(end, x);
  return end > 0 ? end : 1;
}

double endOfY(const CurveChart& chart) {
  double end = 0;
  for (const Curve& c : chart.curves)
    for (const double y : c.y) end = std::max(end, y);
  return end > 0 ? 1.05 * end : 1;
}

/// `$c0 << EOD`: a block for every curve.
std::string dataOf(const CurveChart& chart) {
  std::string text;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    text += fmt::format("$c{} << EOD\n", i);
    for (std::size_t k = 0; k < chart.curves[i].x.size(); ++k)
      text += fmt::format("{:.8g} {:.8g}\n", chart.curves[i].x[k], chart.curves[i].y[k]);
    text += "EOD\n";
  }
  return text;
}

std::string bandsOf(const CurveChart& chart) {
  std::string text;
  for (const Band& b : chart.bands) {
    const int grey = static_cast<int>(std::lround(255 * std::clamp(b.grey, 0.0, 1.0)));
    text += fmt::format(
        "set object rectangle from {:.8g}, graph 0 to {:.8g}, graph 1 behind fc rgb "
        "'#{:02x}{:02x}{:02x}' fs solid noborder\n",
        b.x0, b.x1, grey, grey, grey);
  }
  return text;
}

/// A dotted line with its name. Names side by side would lie over each other: each on a line of
/// its own (six in turn), on white, left of its moment where the frame ends.
std::string momentsOf(const CurveChart& chart) {
  std::string text =
      "set style textbox opaque noborder fillcolor rgb '#26ffffff' margins 0.5, 0.3\n";
  const double end = endOfX(chart);
  for (std::size_t i = 0; i < chart.moments.size(); ++i) {
    const Moment& m = chart.moments[i];
    text += fmt::format(
        "set arrow from {0:.8g}, graph 0 to {0:.8g}, graph 1 nohead back lw 1 dt 3 lc rgb "
        "'#595959'\n",
        m.x);
    const double letter = 8.0 / kPlotWidth;  // at the most
    const bool fits = m.x / end + letter * static_cast<double>(lettersOf(m.name)) < 1;
    text += fmt::format(
        "set label {} at {:.8g}, graph {:.4g} {} offset character {}, 0 front boxed tc rgb "
        "'#404040'\n",
        inQuotes(m.name), m.x, 0.5 - 18 * static_cast<double>(i % 6) / kPlotHeight,
        fits ? "left" : "right", fits ? "0.8" : "-0.8");
  }
  return text;
}

std::string penOf(const CurveChart& chart, std::size_t i, double width) {
  return fmt::format("with lines lw {} dt {} lc rgb '{}'", width,
                     chart.curves[i].dashed ? "(7,4)" : "1",
                     colourOf(chart.curves[i].colour.value_or(i)));
}

/// The first curve is drawn last, on top; the legend has them in order.
std::string plotOf(const CurveChart& chart) {
  std::string text = "plot ";
  for (std::size_t i = chart.curves.size(); i-- > 0;)
    if (!chart.curves[i].x.empty())
      text += fmt::format("$c{} {} notitle, ", i, penOf(chart, i, 1.8));
  for (std::size_t i = 0; i < chart.curves.size(); ++i)
    text += fmt::format("keyentry {} title {}, ", penOf(chart, i, 3),
                        inQuotes(shortened(chart.curves[i].name)));
  return text + "NaN notitle\n";
}

std::string scriptOf(const CurveChart& chart, const std::string& file) {
  const double height = heightOf(chart);
  const auto up = [&](double pixels) { return 1 - pixels / height; };
  return dataOf(chart) +
         fmt::format(
             "set terminal pngcairo size {},{} font 'sans,10' noenhanced background "
             "'#ffffff'\nset output {}\n",
             kWidth, height, inQuotes(file)) +
         fmt::format(
             "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\n"
             "set bmargin at screen {}\n",
             kLeft / kWidth, (kLeft + kPlotWidth) / kWidth, up(kTop), up(kTop + kPlotHeight)) +
         "set border lc rgb '#333333'\nset tics nomirror out tc rgb '#333333'\n"
         "set grid lc rgb '#d0d0d0' lw 1 dt 1\n" +
         fmt::format("set xrange [0:{:.8g}]\nset yrange [0:{:.8g}]\nset xlabel {}\n", endOfX(chart),
                     endOfY(chart), inQuotes(chart.x_label)) +
         fmt::format(
             "set label {} at screen 0.5, screen {} center font ',12'\n"
             "set label {} at graph 0, graph 1 left offset 0, 0.7\n",
             inQuotes(chart.title), up(20), inQuotes(chart.y_label)) +
         fmt::format(
             "set key at screen {}, screen {} top left horizontal maxcols {} Left reverse "
             "samplen 3 width 2\n",
             kLeft / kWidth, up(kTop + kPlotHeight + 58), kLegendColumns) +
         bandsOf(chart) + momentsOf(chart) + plotOf(chart) + "unset output\n";
}

}  // namespace

void writeCurves(const std::filesystem::path& file, const CurveChart& chart) {
  for (const Curve& c : chart.curves)
    if (c.x.size() != c.y.size())
      throw core::Error(fmt::format("cannot draw {}: curve {} has {} x for {} y", file.string(),
                                    c.name, c.x.size(), c.y.size()));
  const auto drawn = drawnFiles({"curves.png"}, [&](const std::filesystem::path& folder) {
    return scriptOf(chart, (folder / "curves.png").string());
  });
  io::writeWhole(file, drawn.front());
}

}  // namespace ariadne::charts
