#include "error_plot.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/report/axes.h"

namespace ariadne::eval_app {
namespace {

using report::Axes;
using report::drawAxes;

constexpr double kWidth = 1000;
constexpr double kHeight = 1120;

/// Green over yellow to red.
void setErrorColour(cairo_t* cr, double share) {
  cairo_set_source_rgb(cr, std::min(1.0, 2 * share) * 0.9, std::min(1.0, 2 - 2 * share) * 0.7, 0.1);
}

/// Equal metres on both axes, all of the truth and the estimate in it.
Axes mapAxes(const TruthResult& r) {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;
  const auto take = [&](const mrpt::math::TPose2D& p) {
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  };
  for (const auto& p : r.pairs) {
    take(p.truth);
    take(geometry::compose(r.truth_from_estimate, p.estimate));
  }
  Axes a{80, 60, 880, 700, 0, 0, 0, 0};
  const double metres_per_pixel =
      1.08 * std::max({(x1 - x0) / a.width, (y1 - y0) / a.height, 1e-4});
  a.x0 = (x0 + x1 - a.width * metres_per_pixel) / 2;
  a.x1 = (x0 + x1 + a.width * metres_per_pixel) / 2;
  a.y0 = (y0 + y1 - a.height * metres_per_pixel) / 2;
  a.y1 = (y0 + y1 + a.height * metres_per_pixel) / 2;
  return a;
}

void drawTrajectories(cairo_t* cr, const TruthResult& r) {
  const Axes a = mapAxes(r);
  drawAxes(cr, a, "x of the truth (m)",
           "y (m); gray: truth, colour: estimate, green no error to red the largest");
  cairo_set_line_width(cr, 3);
  cairo_set_source_rgb(cr, 0.65, 0.65, 0.65);
  for (const auto& p : r.pairs) cairo_line_to(cr, a.x(p.truth.x), a.y(p.truth.y));
  cairo_stroke(cr);
  for (std::size_t i = 0; i < r.pairs.size(); ++i) {
    const auto laid = geometry::compose(r.truth_from_estimate, r.pairs[i].estimate);
    setErrorColour(cr, r.distances_m[i] / std::max(r.absolute_m.max, 1e-12));
    cairo_set_line_width(cr, 1);
    cairo_move_to(cr, a.x(r.pairs[i].truth.x), a.y(r.pairs[i].truth.y));
    cairo_line_to(cr, a.x(laid.x), a.y(laid.y));
    cairo_stroke(cr);
    cairo_arc(cr, a.x(laid.x), a.y(laid.y), 2.5, 0, 2 * M_PI);
    cairo_fill(cr);
  }
}

void drawErrorOverTime(cairo_t* cr, const TruthResult& r) {
  const double start = r.pairs.front().time_s;
  const double end = std::max(r.pairs.back().time_s - start, 1e-3);
  const Axes a{80, 850, 880, 210, 0, end, 0, std::max(1.1 * r.absolute_m.max, 1e-6)};
  drawAxes(cr, a, "time (s)", "distance from the truth (m); dashed: RMSE");
  cairo_set_source_rgb(cr, 0.1, 0.3, 0.7);
  cairo_set_line_width(cr, 1.5);
  for (std::size_t i = 0; i < r.pairs.size(); ++i)
    cairo_line_to(cr, a.x(r.pairs[i].time_s - start), a.y(r.distances_m[i]));
  cairo_stroke(cr);
  const double dashes[] = {6, 4};
  cairo_set_dash(cr, dashes, 2, 0);
  cairo_move_to(cr, a.left, a.y(r.absolute_m.rmse));
  cairo_line_to(cr, a.left + a.width, a.y(r.absolute_m.rmse));
  cairo_stroke(cr);
  cairo_set_dash(cr, nullptr, 0, 0);
}

void draw(cairo_t* cr, const TruthResult& r) {
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
  cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 16);
  report::drawAligned(cr, kWidth / 2, 26,
                      fmt::format("ATE {:.3f} m RMSE, {:.3f} m at the most, {} poses",
                                  r.absolute_m.rmse, r.absolute_m.max, r.absolute_m.count),
                      0.5);
  cairo_set_font_size(cr, 13);
  drawTrajectories(cr, r);
  drawErrorOverTime(cr, r);
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

struct Destroy {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};

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
  std::string bytes;
  {
    const std::unique_ptr<cairo_surface_t, Destroy> surface(
        isSvg(file) ? cairo_svg_surface_create_for_stream(append, &bytes, kWidth, kHeight)
                    : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kWidth),
                                                 static_cast<int>(kHeight)));
    {
      const std::unique_ptr<cairo_t, Destroy> cr(cairo_create(surface.get()));
      draw(cr.get(), result);
      if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS)
        throw core::Error(fmt::format("cannot draw {}: {}", file,
                                      cairo_status_to_string(cairo_status(cr.get()))));
    }
    if (!isSvg(file)) cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    cairo_surface_finish(surface.get());  // an SVG is written only now
  }
  io::writeWhole(file, bytes);
}

}  // namespace ariadne::eval_app
