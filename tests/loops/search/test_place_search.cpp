#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/loops/search/place_search.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

/// What a laser all round sees from the pose.
std::vector<mrpt::math::TPoint2D> seenAllRoundFrom(const TPose2D& pose) {
  const auto scan = test::scanIn(test::roomWorld(), pose, 0, 2 * M_PI);
  return grid::thinned(grid::scanPoints(*scan, 15), 150);
}

/// Within half a cell of the map and the search's last turn of 0.05 degrees and its neighbours.
void expectNear(const TPose2D& found, const TPose2D& truth) {
  EXPECT_LT(std::hypot(found.x - truth.x, found.y - truth.y), 0.08);
  EXPECT_LT(std::abs(std::remainder(found.phi - truth.phi, 2 * M_PI)), 0.02);
}

}  // namespace

TEST(PlaceSearch, OfTheWholeMapTheRightPlaceIsTheBest) {
  const auto map = test::roomMap();
  for (const TPose2D& truth : {TPose2D(1, -1, 2.1), TPose2D(-2, 1, -0.7), TPose2D(3, 0.5, 3.1)}) {
    const auto places = loops::searchPlaces(map, seenAllRoundFrom(truth), {0, 0}, 3);
    ASSERT_FALSE(places.empty());
    expectNear(places[0].map_from_piece, truth);
    EXPECT_GT(places[0].field, 0.5);
    EXPECT_GT(places[0].known_share, 0.9);
    // Turned round, the room has the same four walls; niche and pillar are all the difference.
    // Measured: 0.88 at most.
    for (std::size_t i = 1; i < places.size(); ++i)
      EXPECT_LT(places[i].field, 0.93 * places[0].field);
  }
}

TEST(PlaceSearch, NearAPlaceThatIsSaid) {
  const auto map = test::roomMap();
  const TPose2D truth(1, -1, 2.1);
  expectNear(loops::placeNear(map, seenAllRoundFrom(truth), {1.6, -1.6, 1.9}).map_from_piece,
             truth);
  EXPECT_LT(loops::placeNear(map, seenAllRoundFrom(truth), {1, -1, 0.5}).field, 0.4);
}

TEST(PlaceSearch, TheLaserStandsInFreeSpace) {
  const auto map = test::roomMap();
  const auto points = seenAllRoundFrom({1, -1, 2.1});
  const mrpt::math::TPoint2D far_off(0, 5.5);  // at the right place it would be outside
  for (const auto& place : loops::searchPlaces(map, points, far_off, 20)) {
    const auto laser = place.map_from_piece.composePoint(far_off);
    EXPECT_LT(std::abs(laser.x), 4.5);
    EXPECT_LT(std::abs(laser.y), 3);
    EXPECT_LT(place.field, 0.5);
  }
}
