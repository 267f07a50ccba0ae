#include "ariadne/loops/search/place_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/search/correlation.h"
#include "refine.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using Points = std::vector<TPoint2D>;

constexpr double kSearchCell_m = 0.2;
constexpr double kSearchTurn_rad = 1.5 * M_PI / 180;  // half of it moves a point at 10 m by 0.13 m
constexpr double kOtherPlace_m = 1;
constexpr double kOtherHeading_rad = 15 * M_PI / 180;
constexpr std::size_t kRefined = 12;  // of each quarter of headings

/// A square of the map about `centre`, with as much around it as the piece is long.
HitRaster wallsAbout(const grid::OccupancyGrid& map, const TPose2D& centre, double half_m,
                     const Points& points) {
  double reach = 0;
  for (const TPoint2D& p : points) reach = std::max(reach, std::hypot(p.x, p.y));
  HitRaster raster({centre.x, centre.y}, half_m + reach + 2 * kSearchCell_m, kSearchCell_m);
  const grid::CellBox box = map.knownBox();
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
      if (map.at({x, y}) < 0) raster.mark(map.centreOf({x, y}));
  return raster;
}

bool isElsewhere(const TPose2D& a, const TPose2D& b) {
  return geometry::distance(a, b) > kOtherPlace_m ||
         std::abs(std::remainder(a.phi - b.phi, 2 * M_PI)) > kOtherHeading_rad;
}

/// The cell of the laser itself may lie on the outline of what it saw.
bool isFreeAbout(const grid::OccupancyGrid& map, const TPoint2D& p) {
  constexpr double kAbout_m = 0.15;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    if (map.at(map.cellOf({p.x + dx * kAbout_m, p.y + dy * kAbout_m})) > 0) return true;
  return false;
}

FoundPlace placeAt(const grid::OccupancyGrid& map, const Points& points, const TPose2D& pose) {
  const Refined fine = refine(map, points, pose);
  return {fine.map_from_piece, fine.field, fine.known_share, fine.contradicting};
}

}  // namespace

std::vector<FoundPlace> searchPlaces(const grid::OccupancyGrid& map, const Points& points,
                                     const TPoint2D& laser, std::size_t count) {
  const grid::CellBox box = map.knownBox();
  const TPoint2D low = map.centreOf({box.x0, box.y0});
  const TPoint2D high = map.centreOf({box.x1 - 1, box.y1 - 1});
  const double half_m = std::max(high.x - low.x, high.y - low.y) / 2;
  TPose2D centre((low.x + high.x) / 2, (low.y + high.y) / 2, 0);
  const HitRaster raster = wallsAbout(map, centre, half_m, points);
  std::vector<FoundPlace> all;
  // By quarters of headings: correlate() keeps one heading a place, and its rival may be another.
  for (int quarter = 0; quarter < 4; ++quarter) {
    centre.phi = quarter * M_PI / 2;
    for (const Mode& mode : correlate(raster, points, centre, {half_m, M_PI / 4}, kSearchTurn_rad,
                                      kOtherPlace_m, kRefined)) {
      const FoundPlace place = placeAt(map, points, mode.map_from_piece);
      if (isFreeAbout(map, place.map_from_piece.composePoint(laser))) all.push_back(place);
    }
  }
  std::sort(all.begin(), all.end(),
            [](const FoundPlace& a, const FoundPlace& b) { return a.field > b.field; });
  std::vector<FoundPlace> apart;
  for (const FoundPlace& place : all) {
    if (apart.size() == count) break;
    if (std::all_of(apart.begin(), apart.end(), [&](const FoundPlace& better) {
          return isElsewhere(better.map_from_piece, place.map_from_piece);
        }))
      apart.push_back(place);
  }
  return apart;
}

FoundPlace placeNear(const grid::OccupancyGrid& map, const Points& points,
                     const TPose2D& expected) {
  const HitRaster raster = wallsAbout(map, expected, kOtherPlace_m, points);
  FoundPlace best = placeAt(map, points, expected);
  for (const Mode& mode : correlate(raster, points, expected, {kOtherPlace_m, kOtherHeading_rad},
                                    kSearchTurn_rad, 2 * kSearchCell_m, kRefined)) {
    const FoundPlace place = placeAt(map, points, mode.map_from_piece);
    if (place.field > best.field) best = place;
  }
  return best;
}

}  // namespace ariadne::loops
