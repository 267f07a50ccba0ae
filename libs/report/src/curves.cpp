#include "ariadne/report/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ariadne/core/error.h"
#include "ariadne/report/axes.h"
#include "canvas.h"
#include "encode.h"
#include "moments.h"

namespace ariadne::report {
namespace {

constexpr double kWidth = 1000;
constexpr double kPlotHeight = 420;
constexpr std::size_t kLegendColumns = 3;
constexpr int kLegendRow = 20;  // pixels

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

/// Colour, width and dashes of curve i.
void setPen(cairo_t* cr, const CurveChart& chart, std::size_t i, double width) {
  const std::array<double, 2> dashes{7, 4};
  setColour(cr, chart.curves[i].colour.value_or(i));
  cairo_set_line_width(cr, width);
  cairo_set_dash(cr, dashes.data(), chart.curves[i].dashed ? 2 : 0, 0);
}

void drawCurve(cairo_t* cr, const Axes& a, const Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    cairo_line_to(cr, a.x(curve.x[i]), a.y(curve.y[i]));
  cairo_stroke(cr);
}

void drawBands(cairo_t* cr, const Axes& a, const std::vector<Band>& bands) {
  for (const Band& b : bands) {
    cairo_set_source_rgb(cr, b.grey, b.grey, b.grey);
    cairo_rectangle(cr, a.x(b.x0), a.top, a.x(b.x1) - a.x(b.x0), a.height);
    cairo_fill(cr);
  }
}

int legendRows(const CurveChart& chart) {
  return static_cast<int>((chart.curves.size() + kLegendColumns - 1) / kLegendColumns);
}

void drawLegend(cairo_t* cr, const CurveChart& chart, double top) {
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const double x = 70 + 300 * static_cast<double>(i % kLegendColumns);
    const double y = top + kLegendRow * static_cast<double>(i / kLegendColumns);
    setPen(cr, chart, i, 3);
    cairo_move_to(cr, x, y - 4);
    cairo_line_to(cr, x + 29, y - 4);
    cairo_stroke(cr);
    cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
    drawAligned(cr, x + 36, y, chart.curves[i].name, 0);
  }
  cairo_set_dash(cr, nullptr, 0, 0);
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
  drawBands(cr, axes, chart.bands);
  drawAxes(cr, axes, chart.x_label.c_str(), chart.y_label.c_str());
  drawMomentLines(cr, axes, chart.moments);
  for (std::size_t i = chart.curves.size(); i-- > 0;) {
    setPen(cr, chart, i, 1.8);
    drawCurve(cr, axes, chart.curves[i]);
  }
  cairo_set_dash(cr, nullptr, 0, 0);
  drawMomentNames(cr, axes, chart.moments);
  drawLegend(cr, chart, axes.top + kPlotHeight + 66);
}

}  // namespace

void writeCurves(const std::filesystem::path& file, const CurveChart& chart) {
  for (const Curve& c : chart.curves)
    if (c.x.size() != c.y.size())
      throw core::Error(fmt::format("cannot draw {}: curve {} has {} x for {} y", file.string(),
                                    c.name, c.x.size(), c.y.size()));
  const Surface surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(kWidth),
      static_cast<int>(kPlotHeight) + 140 + kLegendRow * std::max(legendRows(chart) - 1, 0)));
  const Context cr(cairo_create(surface.get()));
  draw(cr.get(), chart);
  if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS)
    throw core::Error(fmt::format("cannot draw {}: {}", file.string(),
                                  cairo_status_to_string(cairo_status(cr.get()))));
  writePng(file, surface);
}

}  // namespace ariadne::report
