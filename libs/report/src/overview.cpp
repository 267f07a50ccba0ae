#include "ariadne/report/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ariadne/core/error.h"
#include "ariadne/io/png.h"
#include "ariadne/io/whole_file.h"
#include "canvas.h"
#include "cells.h"

namespace ariadne::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

constexpr int kLongSide = 1200;   // pixels of map, at most
constexpr int kLeastWidth = 640;  // for the footer's text
constexpr int kMargin = 20;
constexpr int kFooter = 50;  // for scale bar and text

/// Blue over green to red.
void setTimeColour(cairo_t* cr, double share) {
  cairo_set_source_rgb(cr, std::clamp(2 * share - 0.6, 0.05, 0.9),
                       0.65 * (1 - std::abs(2 * share - 1)),
                       std::clamp(1.2 - 2 * share, 0.05, 0.9));
}

/// Every pose takes the same share of the colours: a log with a pause of hours would be all blue
/// and red by the clock.
void drawPath(cairo_t* cr, const models::Trajectory& path, const View& view) {
  constexpr std::size_t kColours = 64;
  if (path.size() < 2) return;
  cairo_set_line_width(cr, 2);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  for (std::size_t k = 0; k < kColours; ++k) {
    const std::size_t from = (path.size() - 1) * k / kColours;
    const std::size_t to = (path.size() - 1) * (k + 1) / kColours;
    if (from == to) continue;
    cairo_move_to(cr, view.x(path[from].pose.x), view.y(path[from].pose.y));
    for (std::size_t i = from + 1; i <= to; ++i)
      cairo_line_to(cr, view.x(path[i].pose.x), view.y(path[i].pose.y));
    setTimeColour(cr, (static_cast<double>(k) + 0.5) / kColours);
    cairo_stroke(cr);
  }
}

/// A dot with a rim: the path's start (share 0) or end (1).
void drawDot(cairo_t* cr, double x, double y, double time_share) {
  cairo_new_path(cr);
  cairo_arc(cr, x, y, 7, 0, 2 * M_PI);
  setTimeColour(cr, time_share);
  cairo_fill_preserve(cr);
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_set_line_width(cr, 2);
  cairo_stroke(cr);
}

double lengthOf(const models::Trajectory& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += std::hypot(path[i].pose.x - path[i - 1].pose.x, path[i].pose.y - path[i - 1].pose.y);
  return sum;
}

/// Longest of 1, 2, 5, 10, ... metres under a quarter of the width.
double barLength(double width_m) {
  double best = 0.1;
  for (double decade = 0.1; decade < 1e5; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (decade * step <= width_m / 4) best = decade * step;
  return best;
}

/// Writes and returns where the text ends.
double drawText(cairo_t* cr, double x, double y, const std::string& text) {
  cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
  cairo_move_to(cr, x, y);
  cairo_show_text(cr, text.c_str());
  cairo_get_current_point(cr, &x, &y);
  return x;
}

/// Start, colours from start to end, end; from x on, text on the line y.
void drawLegend(cairo_t* cr, double x, double y, double seconds) {
  constexpr int kWidth = 96;
  const double middle = y - 5;
  drawDot(cr, x + 8, middle, 0);
  x = drawText(cr, x + 20, y, "start ") + 4;
  for (int i = 0; i < kWidth; ++i) {
    setTimeColour(cr, (i + 0.5) / kWidth);
    cairo_rectangle(cr, std::floor(x) + i, middle - 3, 1, 6);
    cairo_fill(cr);
  }
  drawDot(cr, x + kWidth + 18, middle, 1);
  drawText(cr, x + kWidth + 30, y, fmt::format("end, {:.0f} s later", seconds));
}

void drawFooter(cairo_t* cr, const models::Trajectory& path, const View& view, double width_m,
                double height_m, double bottom) {
  cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 14);
  const double first_line = bottom + 20;
  const double second_line = bottom + 42;

  const double bar = barLength(width_m);
  const double bar_end = view.margin + bar * view.pixels_per_m;
  cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
  cairo_set_line_width(cr, 3);
  cairo_move_to(cr, view.margin, first_line - 5);
  cairo_line_to(cr, bar_end, first_line - 5);
  cairo_stroke(cr);
  drawText(cr, bar_end + 8, first_line, fmt::format("{:g} m", bar));

  const std::string size = fmt::format("map {:.1f} x {:.1f} m", width_m, height_m);
  if (path.empty()) {
    drawText(cr, view.margin, second_line, size);
    return;
  }
  const double x = drawText(cr, view.margin, second_line,
                            fmt::format("{}, path {:.1f} m", size, lengthOf(path)));
  drawLegend(cr, x + 24, second_line, path.back().time_s - path.front().time_s);
}

std::string encode(const Surface& surface) {
  cairo_surface_flush(surface.get());
  io::Picture picture;
  picture.width = static_cast<std::uint32_t>(cairo_image_surface_get_width(surface.get()));
  picture.height = static_cast<std::uint32_t>(cairo_image_surface_get_height(surface.get()));
  picture.format = io::Picture::Format::cairo_rgb;
  picture.pixels = cairo_image_surface_get_data(surface.get());
  picture.stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  return io::encodePng(picture);
}

}  // namespace

void writeOverview(const std::filesystem::path& file, const Grid& map,
                   const models::Trajectory& path) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0)
    throw core::Error(fmt::format("cannot write {}: the map has no cells", file.string()));
  const double cell_m = map.getResolution();
  const Box box = knownCells(map);
  const Scale scale = Scale::fitting(std::max(box.width(), box.height()), kLongSide);
  const int width = std::max(scale.pixelsFor(box.width()), kLeastWidth) + 2 * kMargin;
  const int bottom = kMargin + scale.pixelsFor(box.height());
  View view;
  view.margin = kMargin;
  view.pixels_per_m = scale.pixels / (scale.cells * cell_m);
  view.left_m = map.getXMin() + box.x0 * cell_m;
  view.top_m = map.getYMin() + box.y0 * cell_m + (bottom - kMargin) / view.pixels_per_m;

  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, bottom + kFooter));
  const Context cr(cairo_create(surface.get()));
  const auto check = [&] {
    const cairo_status_t status = cairo_status(cr.get());
    if (status != CAIRO_STATUS_SUCCESS)
      throw core::Error(
          fmt::format("cannot draw {}: {}", file.string(), cairo_status_to_string(status)));
  };
  check();
  cairo_set_source_rgb(cr.get(), 0.804, 0.804, 0.804);
  cairo_paint(cr.get());
  drawCells(surface.get(), map, box, scale, kMargin, bottom);
  drawPath(cr.get(), path, view);
  if (!path.empty()) {
    drawDot(cr.get(), view.x(path.front().pose.x), view.y(path.front().pose.y), 0);
    drawDot(cr.get(), view.x(path.back().pose.x), view.y(path.back().pose.y), 1);
  }
  drawFooter(cr.get(), path, view, box.width() * cell_m, box.height() * cell_m, bottom);
  check();
  io::writeWhole(file, encode(surface));
}

}  // namespace ariadne::report
