#include "ariadne/report/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "map_picture.h"

namespace ariadne::report {
namespace {

using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

void drawEdges(cairo_t* cr, const View& view, const DrawnGraph& graph, const Edges& edges) {
  for (const auto& [a, b] : edges) {
    cairo_move_to(cr, view.x(graph.places[a].x), view.y(graph.places[a].y));
    cairo_line_to(cr, view.x(graph.places[b].x), view.y(graph.places[b].y));
    cairo_stroke(cr);
  }
}

void drawDisc(cairo_t* cr, double x, double y, double radius) {
  cairo_new_path(cr);
  cairo_arc(cr, x, y, radius, 0, 2 * M_PI);
  cairo_fill(cr);
}

void setEdge(cairo_t* cr) { cairo_set_source_rgb(cr, 0.75, 0.1, 0.1); }
void setShortcut(cairo_t* cr) { cairo_set_source_rgb(cr, 0.1, 0.3, 0.85); }

constexpr double kEntryRadius = 9;

/// A disc with a number in it.
void drawEntry(cairo_t* cr, double x, double y, const std::string& text) {
  setShortcut(cr);
  drawDisc(cr, x, y, kEntryRadius);
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_text_extents_t size;
  cairo_text_extents(cr, text.c_str(), &size);
  cairo_move_to(cr, x - size.width / 2 - size.x_bearing, y + size.height / 2);
  cairo_show_text(cr, text.c_str());
  cairo_new_path(cr);
}

/// Loops are often entered where another one was: a disc that would lie on others goes to their
/// right.
void drawEntries(cairo_t* cr, const View& view, const std::vector<DrawnEntry>& entries) {
  std::vector<std::pair<double, double>> taken;
  for (const DrawnEntry& e : entries) {
    double x = view.x(e.position.x);
    const double y = view.y(e.position.y);
    const auto covered = [&] {
      return std::any_of(taken.begin(), taken.end(), [&](const auto& t) {
        return std::hypot(t.first - x, t.second - y) < 2 * kEntryRadius;
      });
    };
    while (covered()) x += 2 * kEntryRadius + 1;
    taken.emplace_back(x, y);
    drawEntry(cr, x, y, fmt::format("{}", e.number));
  }
}

void drawLegend(MapPicture& picture, const DrawnGraph& graph) {
  cairo_t* cr = picture.context();
  const double y = picture.textLine() - 5;
  double x = picture.drawText(
      picture.view().margin, fmt::format("{}, {} places", picture.sizeText(), graph.places.size()));
  x += 16;
  const auto sample = [&](void (*colour)(cairo_t*), const char* text) {
    colour(cr);
    cairo_move_to(cr, x, y);
    cairo_line_to(cr, x + 22, y);
    cairo_stroke(cr);
    x = picture.drawText(x + 28, text) + 16;
  };
  cairo_set_line_width(cr, 3);
  sample(setEdge, "path");
  sample(setShortcut, "closes a cycle");
  drawEntry(cr, x + kEntryRadius, y, "n");
  picture.drawText(x + 24, "entry of closing n");
}

}  // namespace

void writeTopology(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map,
                   const DrawnGraph& graph) {
  MapPicture picture(file, map);
  cairo_t* cr = picture.context();
  const View& view = picture.view();
  setEdge(cr);
  cairo_set_line_width(cr, 2);
  drawEdges(cr, view, graph, graph.edges);
  for (const auto& p : graph.places) drawDisc(cr, view.x(p.x), view.y(p.y), 3.5);
  setShortcut(cr);
  cairo_set_line_width(cr, 3);
  drawEdges(cr, view, graph, graph.shortcuts);
  drawEntries(cr, view, graph.entries);
  picture.drawScaleBar();
  drawLegend(picture, graph);
  picture.write();
}

}  // namespace ariadne::report
