#include "ariadne/report/overview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ariadne/geometry/trajectory.h"
#include "map_picture.h"

namespace ariadne::report {
namespace {

/// Blue over green to red.
void setTimeColour(cairo_t* cr, double share) {
  cairo_set_source_rgb(cr, std::clamp(2 * share - 0.6, 0.05, 0.9),
                       0.65 * (1 - std::abs(2 * share - 1)),
                       std::clamp(1.2 - 2 * share, 0.05, 0.9));
}

/// Every pose takes the same share of the colours: a log with a pause of hours would be all blue
/// and red by the clock.
void drawPath(cairo_t* cr, const geometry::Trajectory& path, const View& view) {
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

/// Start, colours from start to end, end; from x on, on the footer's line.
void drawLegend(MapPicture& picture, double x, double seconds) {
  constexpr int kBarWidth = 96;
  cairo_t* cr = picture.context();
  const double middle = picture.textLine() - 5;
  drawDot(cr, x + 8, middle, 0);
  x = picture.drawText(x + 20, "start ") + 4;
  for (int i = 0; i < kBarWidth; ++i) {
    setTimeColour(cr, (i + 0.5) / kBarWidth);
    cairo_rectangle(cr, std::floor(x) + i, middle - 3, 1, 6);
    cairo_fill(cr);
  }
  drawDot(cr, x + kBarWidth + 18, middle, 1);
  picture.drawText(x + kBarWidth + 30, fmt::format("end, {:.0f} s later", seconds));
}

void drawFooter(MapPicture& picture, const geometry::Trajectory& path) {
  picture.drawScaleBar();
  if (path.empty()) {
    picture.drawText(picture.view().margin, picture.sizeText());
    return;
  }
  const double x = picture.drawText(
      picture.view().margin,
      fmt::format("{}, path {:.1f} m", picture.sizeText(), geometry::lengthOf(path)));
  drawLegend(picture, x + 24, geometry::durationOf(path));
}

}  // namespace

void writeOverview(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map,
                   const geometry::Trajectory& path) {
  MapPicture picture(file, map);
  drawPath(picture.context(), path, picture.view());
  if (!path.empty()) {
    const auto dot = [&](const mrpt::math::TPose2D& p, double share) {
      drawDot(picture.context(), picture.view().x(p.x), picture.view().y(p.y), share);
    };
    dot(path.front().pose, 0);
    dot(path.back().pose, 1);
  }
  drawFooter(picture, path);
  picture.write();
}

}  // namespace ariadne::report
