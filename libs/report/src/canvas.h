// Cairo's objects with owners, and a view from map coordinates to pixels.
#pragma once
#include <cairo.h>

#include <memory>

namespace ariadne::report {

struct CairoDeleter {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};
using Surface = std::unique_ptr<cairo_surface_t, CairoDeleter>;
using Context = std::unique_ptr<cairo_t, CairoDeleter>;

/// Metres, north up, to pixels.
struct View {
  double left_m = 0;  ///< map x of the picture's left border
  double top_m = 0;   ///< map y of its upper border
  double pixels_per_m = 1;
  double margin = 0;  ///< pixels
  double x(double map_x) const { return margin + (map_x - left_m) * pixels_per_m; }
  double y(double map_y) const { return margin + (top_m - map_y) * pixels_per_m; }
};

}  // namespace ariadne::report
