#include "ariadne/report/axes.h"

#include <fmt/format.h>

#include <cmath>

namespace ariadne::report {
namespace {

/// 1, 2 or 5 times a power of ten: about six steps over the span.
double tickStep(double span) {
  const double rough = span / 6;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  for (const double f : {1.0, 2.0, 5.0})
    if (f * decade >= rough) return f * decade;
  return 10 * decade;
}

}  // namespace

void drawAligned(cairo_t* cr, double x, double y, const std::string& s, double align) {
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
    drawAligned(cr, a.x(v), a.top + a.height + 18,
                fmt::format("{:g}", std::abs(v) < x_step / 2 ? 0 : v), 0.5);
  }
  for (double v = std::ceil(a.y0 / y_step) * y_step; v <= a.y1; v += y_step) {
    cairo_set_source_rgb(cr, 0.88, 0.88, 0.88);
    line(a.left, a.y(v), a.left + a.width, a.y(v));
    cairo_set_source_rgb(cr, 0.2, 0.2, 0.2);
    drawAligned(cr, a.left - 8, a.y(v) + 4, fmt::format("{:g}", std::abs(v) < y_step / 2 ? 0 : v),
                1);
  }
  cairo_rectangle(cr, a.left, a.top, a.width, a.height);
  cairo_stroke(cr);
  drawAligned(cr, a.left + a.width / 2, a.top + a.height + 38, x_label, 0.5);
  drawAligned(cr, a.left, a.top - 8, y_label, 0);
}

}  // namespace ariadne::report
