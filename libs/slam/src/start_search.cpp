#include "ariadne/slam/start_search.h"

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/loops/search/piece.h"
#include "ariadne/loops/search/place_search.h"
#include "ariadne/models/motion_model.h"
#include "ariadne/slam/mapper.h"
#include "simple_map.h"

namespace ariadne::slam {
namespace {

using mrpt::math::TPose2D;

constexpr double kPiece_m = 10;
constexpr double kHitRange_m = 25;
constexpr double kSpacing_m = 0.2;
constexpr std::size_t kMostHits = 120;
constexpr std::size_t kMostPoints = 250;
constexpr std::size_t kFewestPoints = 30;

// As closures from metres away are judged (loops::FinderParams), where they were set on logs with
// known closures.
constexpr double kLeastKnown = 0.6;
constexpr double kLeastField = 0.42;
constexpr double kMostContradicting = 0.33;
constexpr double kMostRival = 0.85;
// About a start that is given the map may end. Of 34 starts on the recordings of SENA, Intel and
// MIT CSAIL the field was 0.53 to 0.94 at the right places and at most 0.3 where there was none.
constexpr double kHardlyKnown = 0.15;
constexpr double kLeastFieldOfKnown = 0.6;

/// The first metres, in the frame of the robot at the first scan.
struct Piece {
  std::vector<mrpt::math::TPoint2D> points;
  mrpt::math::TPoint2D laser;
};

Piece firstPiece(const SlamParams& params, int threads,
                 const std::function<std::optional<models::SensorStep>()>& next) {
  SlamParams alone = params;
  alone.loop_closing.enabled = false;
  Mapper mapper(alone, threads);
  double way_m = 0;
  TPose2D last;
  while (way_m < kPiece_m) {
    const auto step = next();
    if (!step) break;
    if (const auto report = mapper.process(*step)) {
      if (report->step > 0) way_m += geometry::distance(last, report->map_from_robot);
      last = report->map_from_robot;
    }
  }
  loops::Track track;
  std::vector<loops::ScanHits> hits;
  const mrpt::maps::CSimpleMap map = mapper.simpleMap();
  Piece piece;
  for (const auto& entry : map) {
    const auto scan = entry.sf->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    hits.push_back(grid::thinned(
        grid::scanPoints(*scan, std::min(kHitRange_m, params.grid.insert_range_m)), kMostHits));
    track.poses.emplace_back(entry.pose->getMeanVal().asTPose());
    if (hits.size() == 1) piece.laser = {scan->sensorPose.x(), scan->sensorPose.y()};
  }
  if (hits.empty()) return piece;
  // From the last scan back to the first, so that the first is the frame.
  std::reverse(hits.begin(), hits.end());
  std::reverse(track.poses.begin(), track.poses.end());
  track.travelled_m.assign(hits.size(), 0);
  piece.points = loops::lastPiece(track, hits, kPiece_m, kSpacing_m, kMostPoints);
  return piece;
}

bool fits(const loops::FoundPlace& place) {
  return place.known_share >= kLeastKnown && place.field >= kLeastField &&
         place.contradicting <= kMostContradicting;
}

StartPlace startAt(const loops::FoundPlace& place) {
  return {place.map_from_piece, place.field, place.known_share};
}

StartSearch checked(const grid::OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& piece,
                    const TPose2D& given) {
  StartSearch search;
  const loops::FoundPlace place = loops::placeNear(map, piece, given);
  search.best = startAt(place);
  if (place.known_share < kHardlyKnown) {
    search.result = StartSearch::Result::unmapped;
    search.best.map_from_robot = given;
  } else if (fits(place) || (place.field >= kLeastFieldOfKnown * place.known_share &&
                             place.contradicting <= kMostContradicting)) {
    search.result = StartSearch::Result::found;
  }
  return search;
}

}  // namespace

StartSearch searchStart(const SlamParams& params, int threads, const mrpt::maps::CSimpleMap& known,
                        const std::function<std::optional<models::SensorStep>()>& next,
                        const std::optional<TPose2D>& given) {
  const auto piece = firstPiece(params, threads, next);
  if (piece.points.size() < kFewestPoints)
    throw core::Error(
        "the first scans of the log show too little to tell where in the known map they were "
        "taken");
  const grid::OccupancyGrid map = gridOf(known, params.grid);
  if (given) return checked(map, piece.points, *given);
  StartSearch search;
  const auto places = loops::searchPlaces(map, piece.points, piece.laser, 2);
  if (places.empty()) return search;
  search.best = startAt(places[0]);
  if (places.size() > 1) search.rival = startAt(places[1]);
  if (!fits(places[0])) return search;
  search.result = search.rival && search.rival->field > kMostRival * search.best.field
                      ? StartSearch::Result::ambiguous
                      : StartSearch::Result::found;
  return search;
}

}  // namespace ariadne::slam
