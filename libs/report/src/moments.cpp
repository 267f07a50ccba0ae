#include "moments.h"

#include <array>

namespace ariadne::report {
namespace {

/// Names side by side would lie over each other, and over curves: each on a line of its own (six in
/// turn), on white, left of its moment where the frame ends.
void drawMomentName(cairo_t* cr, const Axes& a, const Moment& m, std::size_t number) {
  cairo_text_extents_t size;
  cairo_text_extents(cr, m.name.c_str(), &size);
  const double right = a.x(m.x) + 4;
  const double x = right + size.width < a.left + a.width ? right : a.x(m.x) - 6 - size.width;
  const double y = a.top + a.height / 2 + 18 * static_cast<double>(number % 6);
  cairo_set_source_rgba(cr, 1, 1, 1, 0.85);
  cairo_rectangle(cr, x - 2, y - 12, size.width + 5, 16);
  cairo_fill(cr);
  cairo_set_source_rgb(cr, 0.25, 0.25, 0.25);
  drawAligned(cr, x, y, m.name, 0);
}

}  // namespace

void drawMomentLines(cairo_t* cr, const Axes& a, const std::vector<Moment>& moments) {
  const std::array<double, 2> dashes{2, 3};
  cairo_set_source_rgb(cr, 0.35, 0.35, 0.35);
  cairo_set_line_width(cr, 1);
  cairo_set_dash(cr, dashes.data(), 2, 0);
  for (const Moment& m : moments) {
    cairo_move_to(cr, a.x(m.x), a.top);
    cairo_line_to(cr, a.x(m.x), a.top + a.height);
    cairo_stroke(cr);
  }
  cairo_set_dash(cr, nullptr, 0, 0);
}

void drawMomentNames(cairo_t* cr, const Axes& a, const std::vector<Moment>& moments) {
  for (std::size_t i = 0; i < moments.size(); ++i) drawMomentName(cr, a, moments[i], i);
}

}  // namespace ariadne::report
