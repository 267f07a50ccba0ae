#include "ariadne/report/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/io/png.h"
#include "ariadne/io/whole_file.h"
#include "canvas.h"

namespace ariadne::report {
namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

constexpr double kLongSide = 1200;  // pixels of map
constexpr int kMargin = 20;
constexpr int kFooter = 50;  // for scale bar and text

struct Box {
  int x0, y0, x1, y1;
};

/// Cells that are known, at least one.
Box knownCells(const Grid& map) {
  Box box{static_cast<int>(map.getSizeX()), static_cast<int>(map.getSizeY()), 0, 0};
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y) {
    const auto* row = map.getRow(y);
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
      if (row[x] != 0)
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
               std::max(box.y1, y + 1)};
  }
  return box.x0 < box.x1 ? box : Box{0, 0, 1, 1};
}

/// How cells become pixels: `cells` x `cells` of them one pixel, or one of them `pixels` x
/// `pixels`.
struct Scale {
  int cells = 1;
  int pixels = 1;
};

/// Whole numbers only, so that walls are drawn sharp; about kLongSide pixels.
Scale scaleFor(int longest_cells) {
  const auto side = static_cast<int>(kLongSide);
  return {(longest_cells + side - 1) / side, std::clamp(side / longest_cells, 1, 40)};
}

/// Light gray unknown, white free, black walls.
std::uint8_t shade(int log_odds) {
  if (log_odds == 0) return 205;
  return static_cast<std::uint8_t>(log_odds > 0 ? 225 + 30 * log_odds / 127
                                                : 60 + 60 * log_odds / 127);
}

/// The cell that stands for a block: its most occupied, else its most free, so that thin walls
/// stay.
int standsFor(const Grid& map, int x0, int y0, const Box& box, int cells) {
  int low = 0;
  int high = 0;
  for (int y = y0; y < std::min(y0 + cells, box.y1); ++y) {
    const auto* row = map.getRow(y);
    for (int x = x0; x < std::min(x0 + cells, box.x1); ++x) {
      low = std::min<int>(low, row[x]);
      high = std::max<int>(high, row[x]);
    }
  }
  return low < 0 ? low : high;
}

/// Paints the box with its lower left corner at (kMargin, `bottom`).
void drawCells(cairo_surface_t* surface, const Grid& map, const Box& box, const Scale& scale,
               int bottom) {
  cairo_surface_flush(surface);
  unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  int pixel_y = bottom - scale.pixels;
  for (int y = box.y0; y < box.y1; y += scale.cells, pixel_y -= scale.pixels) {
    int pixel_x = kMargin;
    for (int x = box.x0; x < box.x1; x += scale.cells, pixel_x += scale.pixels) {
      const std::uint32_t v = shade(standsFor(map, x, y, box, scale.cells));
      for (int j = 0; j < scale.pixels; ++j) {
        auto* row = reinterpret_cast<std::uint32_t*>(data + std::size_t(pixel_y + j) * stride);
        std::fill_n(row + pixel_x, scale.pixels, v << 16 | v << 8 | v);
      }
    }
  }
  cairo_surface_mark_dirty(surface);
}

/// Blue over green to red.
void setTimeColour(cairo_t* cr, double share) {
  cairo_set_source_rgb(cr, std::clamp(2 * share - 0.6, 0.05, 0.9),
                       0.65 * (1 - std::abs(2 * share - 1)),
                       std::clamp(1.2 - 2 * share, 0.05, 0.9));
}

void drawPath(cairo_t* cr, const models::Trajectory& path, const View& view) {
  constexpr int kColours = 64;
  cairo_set_line_width(cr, 2);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  for (int k = 0; k < kColours && path.size() > 1; ++k) {
    const std::size_t from = (path.size() - 1) * k / kColours;
    const std::size_t to = (path.size() - 1) * (k + 1) / kColours;
    if (from == to) continue;
    cairo_move_to(cr, view.x(path[from].pose.x), view.y(path[from].pose.y));
    for (std::size_t i = from + 1; i <= to; ++i)
      cairo_line_to(cr, view.x(path[i].pose.x), view.y(path[i].pose.y));
    setTimeColour(cr, (k + 0.5) / kColours);
    cairo_stroke(cr);
  }
}

void drawMark(cairo_t* cr, const models::StampedPose& at, const View& view, double time_share) {
  cairo_arc(cr, view.x(at.pose.x), view.y(at.pose.y), 7, 0, 2 * M_PI);
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

void drawFooter(cairo_t* cr, const models::Trajectory& path, const View& view, double width_m,
                double height_m, double bottom) {
  const double bar = barLength(width_m);
  const double y = bottom + 18;
  cairo_set_source_rgb(cr, 0.1, 0.1, 0.1);
  cairo_set_line_width(cr, 3);
  cairo_move_to(cr, view.margin, y);
  cairo_line_to(cr, view.margin + bar * view.pixels_per_m, y);
  cairo_stroke(cr);
  cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, 14);
  cairo_move_to(cr, view.margin, y + 20);
  const double seconds = path.empty() ? 0 : path.back().time_s - path.front().time_s;
  cairo_show_text(cr, fmt::format("{:g} m     map {:.0f} x {:.0f} m     path {:.0f} m in {:.0f} s, "
                                  "blue to red; dots: start and end",
                                  bar, width_m, height_m, lengthOf(path), seconds)
                          .c_str());
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
  const Box box = knownCells(map);
  const Scale scale = scaleFor(std::max(box.x1 - box.x0, box.y1 - box.y0));
  const auto pixels = [&](int cells) {
    return (cells + scale.cells - 1) / scale.cells * scale.pixels;
  };
  const double width_m = (box.x1 - box.x0) * map.getResolution();
  const double height_m = (box.y1 - box.y0) * map.getResolution();
  const int bottom = kMargin + pixels(box.y1 - box.y0);
  View view;
  view.margin = kMargin;
  view.pixels_per_m = scale.pixels / (scale.cells * static_cast<double>(map.getResolution()));
  view.left_m = map.getXMin() + box.x0 * map.getResolution();
  view.top_m =
      map.getYMin() + box.y0 * map.getResolution() + (bottom - kMargin) / view.pixels_per_m;

  const Surface surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, std::max(pixels(box.x1 - box.x0), 560) + 2 * kMargin, bottom + kFooter));
  const Context cr(cairo_create(surface.get()));
  cairo_set_source_rgb(cr.get(), 0.804, 0.804, 0.804);
  cairo_paint(cr.get());
  drawCells(surface.get(), map, box, scale, bottom);
  drawPath(cr.get(), path, view);
  if (!path.empty()) {
    drawMark(cr.get(), path.front(), view, 0);
    drawMark(cr.get(), path.back(), view, 1);
  }
  drawFooter(cr.get(), path, view, width_m, height_m, bottom);
  if (cairo_status(cr.get()) != CAIRO_STATUS_SUCCESS)
    throw core::Error(fmt::format("cannot draw {}: {}", file.string(),
                                  cairo_status_to_string(cairo_status(cr.get()))));
  io::writeWhole(file, encode(surface));
}

}  // namespace ariadne::report
