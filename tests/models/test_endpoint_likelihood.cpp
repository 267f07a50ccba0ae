#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "room.h"

using namespace ariadne;
using mrpt::math::TPoint2D;

TEST(EndpointLikelihood, OneBeamIsTheFormula) {
  const grid::GridParams params;
  const grid::LikelihoodParams likelihood_params;
  grid::OccupancyGrid map(params);
  for (int x = -40; x < 80; ++x)
    for (int y = -40; y < 40; ++y) map.set({x, y}, 50);
  map.set({20, 0}, -50);
  const grid::EndpointLikelihood likelihood(likelihood_params, params.field_sigma_m);
  const TPoint2D wall = map.centreOf({20, 0});
  for (const int cells : {0, 1, 2, 3}) {
    const double d = cells * params.resolution_m;
    const double expected =
        grid::kNominalBeams *
        std::log(likelihood_params.hit_weight *
                     std::exp(-d * d / (2 * std::pow(likelihood_params.hit_sigma_m, 2))) +
                 1 - likelihood_params.hit_weight);
    // The field has 255 steps: half of one is worth up to 1 % of a beam at 2 sigma.
    EXPECT_NEAR(likelihood(map, {{wall.x - d, wall.y}}, {0, 0, 0}), expected, 1.5);
  }
  const double miss = likelihood(map, {{wall.x - 1, wall.y}}, {0, 0, 0});
  EXPECT_NEAR(miss, grid::kNominalBeams * std::log(1 - likelihood_params.hit_weight), 1e-9);
  const double unknown = likelihood(map, {{50, 50}}, {0, 0, 0});
  EXPECT_NEAR(unknown, likelihood_params.unknown_share * miss, 1e-9);
}

TEST(EndpointLikelihood, DoesNotCountBeams) {
  const grid::GridParams params;
  const auto map = test::roomMap(params);
  const grid::EndpointLikelihood likelihood({}, params.field_sigma_m);
  const auto points = grid::scanPoints(*test::scanIn(test::roomWorld(), {0.1, 0, 0.2}), 30);
  std::vector<TPoint2D> twice = points;
  twice.insert(twice.end(), points.begin(), points.end());
  const mrpt::math::TPose2D pose(0.12, 0.02, 0.21);
  EXPECT_NEAR(likelihood(map, points, pose), likelihood(map, twice, pose), 1e-9);
  EXPECT_EQ(likelihood(map, {}, pose), 0);
}

TEST(EndpointLikelihood, InformationIsPositiveAndTellsACorridor) {
  const grid::GridParams params;
  const grid::EndpointLikelihood likelihood({}, params.field_sigma_m);
  const auto points = grid::scanPoints(*test::scanIn(test::roomWorld(), {0.1, 0, 0.2}), 30);
  const auto in_room = likelihood.information(test::roomMap(params), points, {0.1, 0, 0.2});
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(in_room).eigenvalues().minCoeff(), 100);

  grid::OccupancyGrid corridor(params);
  std::vector<TPoint2D> walls;
  for (int x = -400; x < 400; ++x)
    for (const int y : {-20, 20}) corridor.set({x, y}, -50);
  for (double x = -4; x < 4; x += 0.08)
    for (const double y : {-0.975, 1.025}) walls.push_back({x, y});
  const auto h = likelihood.information(corridor, walls, {0, 0, 0});
  EXPECT_LT(h(0, 0), 0.05 * h(1, 1));
}

TEST(Thinned, KeepsOrderAndEnds) {
  std::vector<TPoint2D> points;
  for (int i = 0; i < 361; ++i) points.push_back({static_cast<double>(i), 0});
  const auto few = grid::thinned(points, 180);
  ASSERT_EQ(few.size(), 180U);
  EXPECT_EQ(few.front().x, 0);
  EXPECT_GE(few.back().x, 358);
  EXPECT_EQ(grid::thinned(points, 500).size(), 361U);
}
