#include "map_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "cells.h"
#include "encode.h"

namespace ariadne::report {
namespace {

constexpr int kLongSide = 1200;   // pixels of map, at most
constexpr int kLeastWidth = 640;  // for the footer's text
constexpr int kMargin = 20;
constexpr int kFooter = 50;  // for scale bar and text

/// Longest of 1, 2, 5, 10, ... metres under a quarter of the width.
double barLength(double width_m) {
  double best = 0.1;
  for (double decade = 0.1; decade < 1e5; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (decade * step <= width_m / 4) best = decade * step;
  return best;
}

}  // namespace

MapPicture::MapPicture(std::filesystem::path file, const mrpt::maps::COccupancyGridMap2D& map)
    : file_(std::move(file)) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0)
    throw core::Error(fmt::format("cannot write {}: the map has no cells", file_.string()));
  const double cell_m = map.getResolution();
  const Box box = knownCells(map);
  const Scale scale = Scale::fitting(std::max(box.width(), box.height()), kLongSide);
  const int width = std::max(scale.pixelsFor(box.width()), kLeastWidth) + 2 * kMargin;
  const int bottom = kMargin + scale.pixelsFor(box.height());
  width_m_ = box.width() * cell_m;
  height_m_ = box.height() * cell_m;
  bottom_ = bottom;
  view_.margin = kMargin;
  view_.pixels_per_m = scale.pixels / (scale.cells * cell_m);
  view_.left_m = map.getXMin() + box.x0 * cell_m;
  view_.top_m = map.getYMin() + box.y0 * cell_m + (bottom - kMargin) / view_.pixels_per_m;
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, bottom + kFooter));
  context_.reset(cairo_create(surface_.get()));
  check();
  cairo_set_source_rgb(context(), 0.804, 0.804, 0.804);
  cairo_paint(context());
  drawCells(surface_.get(), map, box, scale, kMargin, bottom);
  cairo_select_font_face(context(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context(), 14);
}

void MapPicture::check() const {
  const cairo_status_t status = cairo_status(context_.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw core::Error(
        fmt::format("cannot draw {}: {}", file_.string(), cairo_status_to_string(status)));
}

std::string MapPicture::sizeText() const {
  return fmt::format("map {:.1f} x {:.1f} m", width_m_, height_m_);
}

void MapPicture::drawScaleBar() {
  const double line = bottom_ + 20;
  const double bar = barLength(width_m_);
  const double bar_end = view_.margin + bar * view_.pixels_per_m;
  cairo_set_source_rgb(context(), 0.1, 0.1, 0.1);
  cairo_set_line_width(context(), 3);
  cairo_move_to(context(), view_.margin, line - 5);
  cairo_line_to(context(), bar_end, line - 5);
  cairo_stroke(context());
  cairo_move_to(context(), bar_end + 8, line);
  cairo_show_text(context(), fmt::format("{:g} m", bar).c_str());
}

double MapPicture::drawText(double x, const std::string& text) {
  cairo_set_source_rgb(context(), 0.1, 0.1, 0.1);
  cairo_move_to(context(), x, textLine());
  cairo_show_text(context(), text.c_str());
  double y = 0;
  cairo_get_current_point(context(), &x, &y);
  cairo_new_path(context());
  return x;
}

void MapPicture::write() {
  check();
  writePng(file_, surface_);
}

}  // namespace ariadne::report
