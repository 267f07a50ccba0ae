#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ariadne/loops/places/place_graph.h"
#include "corridors.h"

using namespace ariadne;
using loops::PlaceGraph;
using loops::PlaceParams;

namespace {

PlaceGraph driven(const grid::OccupancyGrid& map, const std::vector<mrpt::math::TPoint2D>& path,
                  const PlaceParams& params = {}) {
  PlaceGraph graph;
  for (const auto& p : path) graph.extend(p, map, params);
  return graph;
}

double length(const PlaceGraph& graph) {
  double sum = 0;
  graph.edges().forEach([&](const loops::Edge& e) { sum += e.length_m; });
  return sum;
}

/// Floyd and Warshall, as a second opinion.
std::vector<double> bruteDistances(const PlaceGraph& g) {
  const std::size_t n = g.places().size();
  std::vector<std::vector<double>> d(
      n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < n; ++i) d[i][i] = 0;
  g.edges().forEach([&](const loops::Edge& e) {
    d[e.a][e.b] = std::min(d[e.a][e.b], double{e.length_m});
    d[e.b][e.a] = d[e.a][e.b];
  });
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  std::vector<double> from(n);
  for (std::size_t i = 0; i < n; ++i)
    from[i] = d[g.visits().back().place][i] + g.visits().back().stub_m;
  return from;
}

}  // namespace

TEST(PlaceGraph, MakesAPlaceEachSpacing) {
  const auto graph = driven(test::ringMap(16), test::ringPath(16, 12.1));
  EXPECT_EQ(graph.places().size(), 7U);  // 0, 2, ... 12 m
  EXPECT_EQ(graph.edges().size(), 6U);
  EXPECT_NEAR(length(graph), 12, 1e-5);
  EXPECT_EQ(graph.visits().size(), 31U);
}

TEST(PlaceGraph, MakesAPlaceWhereNoneIsInSight) {
  grid::OccupancyGrid map;
  test::drawRoom(map, -1, -1, 10, 1);
  PlaceParams params;
  params.place_spacing_m = 50;
  params.place_range_m = 3;
  params.visit_radius_m = 0.5;
  const auto graph = driven(map, test::ringPath(16, 7), params);
  EXPECT_EQ(graph.places().size(), 3U);  // 0, then past 3 m, then past 6.x m
}

TEST(PlaceGraph, AVisitToAnOldPlaceClosesTheCycle) {
  const auto map = test::ringMap(8);
  const auto before = driven(map, test::ringPath(8, 29));
  const auto after = driven(map, test::ringPath(8, 33));
  EXPECT_EQ(before.edges().size(), before.places().size() - 1);
  EXPECT_EQ(after.places().size(), before.places().size() + (before.places().size() == 15 ? 1 : 0));
  EXPECT_EQ(after.edges().size(), after.places().size());
  EXPECT_EQ(after.visits().back().place, 0U);
  EXPECT_NEAR(length(after), 32, 0.5);
}

TEST(PlaceGraph, MoreLapsMakeNoMorePlaces) {
  const auto map = test::ringMap(8);
  const auto one = driven(map, test::ringPath(8, 34));
  const auto five = driven(map, test::ringPath(8, 160));
  EXPECT_EQ(five.places().size(), one.places().size());
  EXPECT_LE(five.edges().size(), one.edges().size() + 2);
}

TEST(PlaceGraph, AWallKeepsPlacesApart) {
  grid::OccupancyGrid map;
  test::drawRoom(map, -1, -1, 20, 1);
  test::drawRoom(map, -1, 1.2, 20, 3);
  PlaceGraph graph;
  for (double x = 0; x < 10; x += 0.4) graph.extend({x, 0.5}, map, {});
  const auto places = graph.places().size();
  graph.extend({9, 1.5}, map, {});  // 1 m from a place, but behind the wall
  EXPECT_EQ(graph.places().size(), places + 1);
}

TEST(PlaceGraph, ShortestWaysAreThoseOfBruteForce) {
  const auto map = test::ringMap(8);
  for (const double l : {0.3, 10.0, 31.0, 33.0, 50.0, 75.3}) {
    const auto graph = driven(map, test::ringPath(8, l));
    const auto brute = bruteDistances(graph);
    const auto fast = graph.distances();
    ASSERT_EQ(fast.size(), brute.size());
    for (std::size_t i = 0; i < fast.size(); ++i) EXPECT_NEAR(fast[i], brute[i], 1e-9);
  }
}

TEST(PlaceGraph, ClosingALoopShortensTheWay) {
  const auto map = test::ringMap(8);
  auto graph = driven(map, test::ringPath(8, 29));
  EXPECT_GT(graph.distances()[0], 25);
  graph.close(0);
  EXPECT_LT(graph.distances()[0], 6);
  const auto edges = graph.edges().size();
  graph.close(0);
  EXPECT_EQ(graph.edges().size(), edges) << "once is enough";
}

TEST(PlaceGraph, AsOfAPastUpdateIsTheGraphOfThatTime) {
  const auto map = test::ringMap(8);
  const auto path = test::ringPath(8, 70);
  const auto full = driven(map, path);
  for (std::size_t step = 0; step < path.size(); step += 7) {
    const auto then = driven(map, {path.begin(), path.begin() + step + 1});
    const auto past = full.asOf(step);
    EXPECT_EQ(past.places().size(), then.places().size());
    EXPECT_EQ(past.edges().size(), then.edges().size());
    EXPECT_EQ(past.visits().size(), then.visits().size());
    EXPECT_EQ(past.distances(), then.distances());
  }
  EXPECT_THROW(full.asOf(path.size()), std::out_of_range);
}

TEST(PlaceGraph, AttachingItsOwnWayGivesTheSameGraph) {
  const auto map = test::ringMap(8);
  const auto path = test::ringPath(8, 70);
  auto full = driven(map, path);
  full.close(3);
  for (const std::size_t te : {0U, 5U, 40U, 100U}) {
    auto past = full.asOf(te);
    past.attach(full, {path.begin() + te + 1, path.end()});
    EXPECT_EQ(past.places().size(), full.places().size());
    EXPECT_EQ(past.edges().size(), full.edges().size());
    EXPECT_EQ(past.distances(), full.distances());
    EXPECT_EQ(past.lastVisit(2), full.lastVisit(2));
  }
}

TEST(PlaceGraph, LastVisitIsWhenTheRobotWasThereLast) {
  const auto map = test::ringMap(8);
  const auto path = test::ringPath(8, 40);
  const auto graph = driven(map, path);
  const std::size_t te = graph.lastVisit(1);
  EXPECT_EQ(graph.visits()[te].place, 1U);
  for (std::size_t i = te + 1; i < path.size(); ++i)
    EXPECT_FALSE(graph.visits()[i].place == 1 && graph.visits()[i].inside);
  EXPECT_GT(te, 80U) << "on the second lap";
}
