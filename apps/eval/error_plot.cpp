#include "error_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ariadne/charts/gnuplot.h"
#include "ariadne/charts/gnuplot_text.h"
#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::eval_app {
namespace {

using charts::inQuotes;

/// $pairs: s since the first pair, the truth's x and y, the estimate's laid over it, m, error, m.
std::string dataOf(const TruthResult& r) {
  std::string text = "$pairs << EOD\n";
  for (std::size_t i = 0; i < r.pairs.size(); ++i) {
    const auto& p = r.pairs[i];
    const auto laid = geometry::compose(r.truth_from_estimate, p.estimate);
    text += fmt::format("{:.6f} {:.5f} {:.5f} {:.5f} {:.5f} {:.6g}\n",
                        p.time_s - r.pairs.front().time_s, p.truth.x, p.truth.y, laid.x, laid.y,
                        r.distances_m[i]);
  }
  return text + "EOD\n";
}

/// Equal metres on both axes, all of the truth and the estimate in it. Green over yellow to red.
std::string mapPanel(const TruthResult& r) {
  return fmt::format(
      "set size 1, 0.68\nset origin 0, 0.3\nset size ratio -1\n"
      "set xlabel 'x of the truth (m)'\nset ylabel 'y (m)'\nset offsets graph 0.03, graph 0.03, "
      "graph 0.03, graph 0.03\n"
      "set palette functions 0.9 * (gray < 0.5 ? 2 * gray : 1), "
      "0.7 * (gray < 0.5 ? 1 : 2 - 2 * gray), 0.1\n"
      "set cbrange [0:{:.6g}]\nset cblabel 'distance from the truth (m)'\n"
      "plot $pairs using 2:3 with lines lw 3 lc rgb '#a6a6a6' title 'truth', "
      "'' using 2:3:($4-$2):($5-$3):6 with vectors nohead lc palette notitle, "
      "'' using 4:5:6 with points pt 7 ps 0.5 lc palette title 'estimate'\n",
      std::max(r.absolute_m.max, 1e-12));
}

std::string timePanel(const TruthResult& r) {
  return fmt::format(
      "reset\nset border 3\nset tics nomirror out\nset grid lc rgb '#e0e0e0' lw 1 dt 1\n"
      "set size 1, 0.3\nset origin 0, 0\nset xlabel 'time (s)'\n"
      "set ylabel 'distance from the truth (m)'\nset key top left opaque\n"
      "set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]\n"
      "plot $pairs using 1:6 with lines lw 1.5 lc rgb '{}' title 'distance', {:.6g} "
      "with lines lw 1.5 dt 2 lc rgb '{}' title 'RMSE'\n",
      std::max(r.pairs.back().time_s - r.pairs.front().time_s, 1e-3),
      std::max(1.25 * r.absolute_m.max, 1e-6), charts::colourOf(0), r.absolute_m.rmse,
      charts::colourOf(1));
}

std::string scriptOf(const TruthResult& r, const std::string& file, bool svg) {
  const std::string title = fmt::format("ATE {:.3f} m RMSE, {:.3f} m at the most, {} poses",
                                        r.absolute_m.rmse, r.absolute_m.max, r.absolute_m.count);
  return dataOf(r) +
         fmt::format(
             "set terminal {} size 1000,1120 font 'sans,{}' noenhanced background "
             "'#ffffff'\nset output {}\n",
             svg ? "svg fixed" : "pngcairo", svg ? 14 : 11, inQuotes(file)) +
         "set multiplot title " + inQuotes(title) +
         "\nset border 3\nset tics nomirror out\nset grid lc rgb '#e0e0e0' lw 1 dt 1\n" +
         "set key top left opaque\n" + mapPanel(r) + timePanel(r) +
         "unset multiplot\nunset output\n";
}

bool isSvg(const std::string& file) { return std::filesystem::path(file).extension() == ".svg"; }

}  // namespace

void checkPlotFile(const std::string& file, bool overwrite) {
  const auto extension = std::filesystem::path(file).extension();
  if (extension != ".svg" && extension != ".png")
    throw core::UsageError(fmt::format("--plot {}: a plot is a .png or .svg file", file));
  if (!overwrite && std::filesystem::exists(file))
    throw core::Error(fmt::format("{} exists; -w replaces it", file));
}

void writeErrorPlot(const std::string& file, const TruthResult& result, bool overwrite) {
  checkPlotFile(file, overwrite);
  const std::string name = isSvg(file) ? "errors.svg" : "errors.png";
  const auto drawn = charts::drawnFiles({name}, [&](const std::filesystem::path& folder) {
    return scriptOf(result, (folder / name).string(), isSvg(file));
  });
  io::writeWhole(file, drawn.front());
}

}  // namespace ariadne::eval_app
