#include "ariadne/report/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ariadne/core/error.h"
#include "ariadne/report/axes.h"
#include "canvas.h"
#include "encode.h"

namespace ariadne::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kPlotHeight = 420;

void setColour(cairo_t* cr, std::size_t i) {
  // Okabe and Ito's colours, told apart by the colour-blind too.
  constexpr std::array<std::array<double, 3>, 6> colours{{{0.0, 0.45, 0.70},
                                                          {0.84, 0.37, 0.0},
                                                          {0.0, 0.62, 0.45},
                                                          {0.80, 0.47, 0.65},
                                                          {0.34, 0.71, 0.91},
                                                          {0.90, 0.62, 0.0}}};
  const auto& c = colours[i % colours.size()];
  cairo_set_source_rgb(cr, c[0], c[1], c[2]);
}

Axes axesOf(const CurveChart& chart) {
  Axes a{70, 60, kWidth - 100, kPlotHeight, 0, 1, 0, 1};
  for (const Curve& c : chart.curves) {
    for (const double x : c.x) a.x1 = std::max(a.x1, x);
    for (const double y : c.y) a.y1 = std::max(a.y1, 1.05 * y);
  }
  return a;
}

void drawCurve(cairo_t* cr, const Axes& a, const Curve& curve) {
  cairo_set_line_width(cr, 1.8);
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    cairo_line_to(cr, a.x(curve.x[i]), a.y(curve.y[i]));
  cairo_stroke(cr);
}

void drawMoment(cairo_t* cr, const Axes& a, const Moment& m, std::size_t number) {
  const std::array<double, 2> dashes{5, 4};
  cairo_set_source_rgb(cr, 0.35, 0.35, 0.35);
  cairo_set_line_width(cr, 1);
  cairo_set_dash(cr, dashes.data(), 2, 0);
  cairo_move_to(cr, a.x(m.x), a.top);
  cairo_line_to(cr, a.x(m.x), a.top + a.height);
  cairo_stroke(cr);
  cairo_set_dash(cr, nullptr, 0, 0);
  // Names side by side would lie over each other.
  drawAligned(cr, a.x(m.x) + 4, a.top + a.height / 2 + 16 * static_cast<double>(number % 6), m.name,
              0);
}

void drawLegend(cairo_t* cr, const CurveChart& chart, double y) {
  double x = 70;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    setColour(cr, i);
    cairo_set_line_width(cr, 3);
    cairo_move_to(cr, x, y - 4);
    cairo_line_to(cr, x + 24, y - 4);
    cairo_stroke(cr);
    cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
    cairo_text_extents_t size;
    cairo_text_extents(cr, chart.curves[i].name.c_str(), &size);
    drawAligned(cr, x + 30, y, chart.curves[i].name, 0);
    x += 60 + size.width;
    if (x > kWidth - 250) {
      x = 70;
      y += 20;
    }
  }
}

void draw(cairo_t* cr, const CurveChart& chart) {
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
  cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 16);
  drawAligned(cr, kWidth / 2, 24, chart.title, 0.5);
  cairo_set_font_size(cr, 13);
  const Axes axes = axesOf(chart);
  drawAxes(cr, axes, chart.x_label.c_str(), chart.y_label.c_str());
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    setColour(cr, i);
    drawCurve(cr, axes, chart.curves[i]);
  }
  for (std::size_t i = 0; i < chart.moments.size(); ++i) drawMoment(cr, axes, chart.moments[i], i);
  drawLegend(cr, chart, axes.top + kPlotHeight + 66);
}

}  // namespace

void writeCurves(const std::filesystem::path& file, const CurveChart& chart) {
  for (const Curve& c : chart.curves)
    if (c.x.size() != c.y.size())
      throw core::Error(fmt::format("cannot draw {}: curve {} has {} x for {} y", file.string(),
                                    c.name, c.x.size(), c.y.size()));
  const int rows = static_cast<int>(chart.curves.size()) / 3;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kWidth),
                                 static_cast<int>(kPlotHeight) + 140 + 20 * rows));
  const Context cr(cairo_create(surface.get()));
  draw(cr.get(), chart);
  if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS)
    throw core::Error(fmt::format("cannot draw {}: {}", file.string(),
                                  cairo_status_to_string(cairo_status(cr.get()))));
  writePng(file, surface);
}

}  // namespace ariadne::report
