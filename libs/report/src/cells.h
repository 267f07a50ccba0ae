// The map's cells as pixels.
#pragma once
#include <cairo.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

namespace ariadne::report {

/// Cells x0 <= x < x1 and y0 <= y < y1.
struct Box {
  int x0, y0, x1, y1;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

/// The smallest box around the known cells; where none is, the map's first cell.
Box knownCells(const mrpt::maps::COccupancyGridMap2D& map);

/// How cells become pixels: `cells` x `cells` of them one pixel, or one of them `pixels` x
/// `pixels`. Whole numbers only, so that walls are drawn sharp and quickly.
struct Scale {
  int cells = 1;
  int pixels = 1;
  /// The largest with which `longest_cells` take no more than `side` pixels.
  static Scale fitting(int longest_cells, int side);
  int pixelsFor(int n_cells) const { return (n_cells + cells - 1) / cells * pixels; }
};

/// Paints the box on an image of CAIRO_FORMAT_RGB24 with its lower left corner at pixel (`left`,
/// `bottom`): light gray unknown, white free, black occupied.
void drawCells(cairo_surface_t* image, const mrpt::maps::COccupancyGridMap2D& map, const Box& box,
               const Scale& scale, int left, int bottom);

}  // namespace ariadne::report
