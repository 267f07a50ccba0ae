// Axes of a chart, drawn with Cairo.
#pragma once
#include <cairo.h>

#include <string>

namespace ariadne::report {

/// A rectangle of the page with its range of values; y grows upwards in values, downwards on paper.
struct Axes {
  double left, top, width, height;
  double x0, x1, y0, y1;
  double x(double v) const { return left + (v - x0) / (x1 - x0) * width; }
  double y(double v) const { return top + height - (v - y0) / (y1 - y0) * height; }
};

/// Text with its left end (align 0), middle (0.5) or right end (1) at x.
void drawAligned(cairo_t* cr, double x, double y, const std::string& text, double align);

/// Frame, grid lines with numbers at round values, the y axis' label above it.
void drawAxes(cairo_t* cr, const Axes& axes, const char* x_label, const char* y_label);

}  // namespace ariadne::report
