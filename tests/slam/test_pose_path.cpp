#include <gtest/gtest.h>

#include "ariadne/slam/pose_path.h"

using namespace ariadne;
using slam::OdometryRecord;

namespace {

filter::AncestorPtr node(filter::AncestorPtr parent, std::size_t step, double x) {
  return std::make_shared<filter::Ancestor>(std::move(parent), step, mrpt::math::TPose2D(x, 0, 0),
                                            0);
}

}  // namespace

TEST(PosePath, HitsTheUpdatesAndBlendsBetweenThem) {
  // Odometry says 1 m a step; the filter says the second metre was 1.2 m.
  const std::vector<OdometryRecord> records{{0, {0, 0, 0}, 0, false},
                                            {1, {1, 0, 0}, 1, true},
                                            {2, {1.5, 0, 0}, 1, false},
                                            {3, {2, 0, 0}, 2, true},
                                            {4, {2.5, 0, 0}, 2, false}};
  const auto path = slam::posePath(records, node(node(nullptr, 0, 10), 1, 11.2));
  ASSERT_EQ(path.size(), 5U);
  EXPECT_NEAR(path[0].pose.x, 9, 1e-12);  // back from the first update
  EXPECT_NEAR(path[1].pose.x, 10, 1e-12);
  EXPECT_NEAR(path[2].pose.x, 10.6, 1e-12);  // half of the correction
  EXPECT_NEAR(path[3].pose.x, 11.2, 1e-12);
  EXPECT_NEAR(path[4].pose.x, 11.7, 1e-12);  // on from the last
}

TEST(PosePath, AnErrorOfATurnIsOfTheTurn) {
  // The robot moves on by 0.1 m, then turns: by 0.6 rad, of which the odometry saw 0.4.
  filter::AncestorPtr path_of_one = std::make_shared<filter::Ancestor>(
      node(nullptr, 0, 0), 1, mrpt::math::TPose2D(0.1, 0, 0.6), 0);
  const auto path = slam::posePath({{0, {0, 0, 0}, 1, true},
                                    {1, {0.1, 0, 0}, 1, false},
                                    {2, {0.1, 0, 0.2}, 1, false},
                                    {3, {0.1, 0, 0.4}, 2, true}},
                                   path_of_one);
  EXPECT_NEAR(path[1].pose.phi, 0.2 * 0.1 / 0.5, 1e-12) << "a fifth of the motion";
  EXPECT_NEAR(path[2].pose.phi, 0.2 + 0.2 * 0.3 / 0.5, 1e-12);
  EXPECT_NEAR(path[3].pose.phi, 0.6, 1e-12);
}

TEST(PosePath, WithoutUpdatesItIsTheOdometry) {
  const auto path = slam::posePath({{0, {1, 2, 3}, 0, false}}, nullptr);
  ASSERT_EQ(path.size(), 1U);
  EXPECT_EQ(path[0].pose.x, 1);
  EXPECT_TRUE(slam::posePath({}, nullptr).empty());
}
