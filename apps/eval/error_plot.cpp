#include "error_plot.h"

#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/models/motion_model.h"

namespace ariadne::eval_app {
namespace {

constexpr double kWidth = 1000;
constexpr double kHeight = 1120;

/// A rectangle of the page with its range of values; y grows upwards in values, downwards on paper.
struct Axes {
  double left, top, width, height;
  double x0, x1, y0, y1;
  double x(double v) const { return left + (v - x0) / (x1 - x0) * width; }
  double y(double v) const { return top + height - (v - y0) / (y1 - y0) * height; }
};

/// 1, 2 or 5 times a power of ten: about six steps over the span.
double tickStep(double span) {
  const double rough = span / 6;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  for (const double f : {1.0, 2.0, 5.0})
    if (f * decade >= rough) return f * decade;
  return 10 * decade;
}

void text(cairo_t* cr, double x, double y, const std::string& s, double align) {
  cairo_text_extents_t size;
  cairo_text_extents(cr, s.c_str(), &size);
  cairo_move_to(cr, x - align * size.width, y);
  cairo_show_text(cr, s.c_str());
  cairo_new_path(cr);  // else the next line begins at the text's end
}

void drawAxes(cairo_t* cr, const Axes& a, const char* x_label, const char* y_label) {
  cairo_set_line_width(cr, 1);
  const double x_step = tickStep(a.x1 - a.x0);
  const double y_step = tickStep(a.y1 - a.y0);
  const auto line = [&](double xa, double ya, double xb, double yb) {
    cairo_move_to(cr, xa, ya);
    cairo_line_to(cr, xb, yb);
    cairo_stroke(cr);
  };
  for (double v = std::ceil(a.x0 / x_step) * x_step; v <= a.x1; v += x_step) {
    cairo_set_source_rgb(cr, 0.88, 0.88, 0.88);
    line(a.x(v), a.top, a.x(v), a.top + a.height);
    cairo_set_source_rgb(cr, 0.2, 0.2, 0.2);
    text(cr, a.x(v), a.top + a.height + 18, fmt::format("{:g}", std::abs(v) < x_step / 2 ? 0 : v),
         0.5);
  }
  for (double v = std::ceil(a.y0 / y_step) * y_step; v <= a.y1; v += y_step) {
    cairo_set_source_rgb(cr, 0.88, 0.88, 0.88);
    line(a.left, a.y(v), a.left + a.width, a.y(v));
    cairo_set_source_rgb(cr, 0.2, 0.2, 0.2);
    text(cr, a.left - 8, a.y(v) + 4, fmt::format("{:g}", std::abs(v) < y_step / 2 ? 0 : v), 1);
  }
  cairo_rectangle(cr, a.left, a.top, a.width, a.height);
  cairo_stroke(cr);
  text(cr, a.left + a.width / 2, a.top + a.height + 38, x_label, 0.5);
  text(cr, a.left, a.top - 8, y_label, 0);
}

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
    take(models::compose(r.truth_from_estimate, p.estimate));
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
    const auto laid = models::compose(r.truth_from_estimate, r.pairs[i].estimate);
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
  text(cr, kWidth / 2, 26,
       fmt::format("ATE {:.3f} m RMSE, {:.3f} m at the most, {} poses", r.absolute_m.rmse,
                   r.absolute_m.max, r.absolute_m.count),
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
