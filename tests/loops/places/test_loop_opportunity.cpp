#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/loops/places/loop_opportunity.h"
#include "corridors.h"

using namespace ariadne;
using loops::findOpportunity;
using loops::OpportunityParams;
using loops::PlaceGraph;

namespace {

constexpr double kSide = 12;

struct Robot {
  explicit Robot(double driven_m) : map(test::ringMap(kSide)) {
    for (const auto& p : test::ringPath(kSide, driven_m)) {
      graph.extend(p, map, {});
      position = p;
    }
  }
  std::optional<loops::LoopOpportunity> look(const OpportunityParams& params = {}) const {
    return findOpportunity(graph, map, position, params, [](const auto&) { return true; });
  }
  grid::OccupancyGrid map;
  PlaceGraph graph;
  mrpt::math::TPoint2D position;
};

}  // namespace

TEST(LoopOpportunity, OpensWithinC1OfTheEntry) {
  EXPECT_FALSE(Robot(30).look());
  EXPECT_FALSE(Robot(37).look()) << "11 m left";
  const auto found = Robot(40.1).look();  // at 40 m of 48: 8 m left
  ASSERT_TRUE(found);
  EXPECT_EQ(found->entry, 0U);
  EXPECT_NEAR(found->dist_m_m, 8, 0.35) << "to within the robot's radius";
  EXPECT_NEAR(found->dist_g_m, 40, 1);
  EXPECT_EQ(found->te, 3U) << "last of the updates within the visit radius of the start";
}

TEST(LoopOpportunity, PlacesOfInterestAreNearByTheMapAndFarByTheGraph) {
  const OpportunityParams params;
  const auto found = Robot(40.1).look(params);
  ASSERT_TRUE(found);
  ASSERT_FALSE(found->places.empty());
  double nearest = params.c1_m;
  for (const loops::PlaceOfInterest& p : found->places) {
    EXPECT_LT(p.dist_m, params.c1_m);
    EXPECT_GT(p.dist_g, params.c2_m);
    nearest = std::min(nearest, p.dist_m);
    if (p.place == found->entry) {
      EXPECT_EQ(p.dist_m, found->dist_m_m);
    }
  }
  EXPECT_EQ(nearest, found->dist_m_m) << "the entry is the nearest of them";
}

TEST(LoopOpportunity, IsGoneOnceTheGraphKnowsTheWay) {
  EXPECT_FALSE(Robot(50).look());
  Robot robot(40.1);
  robot.graph.close(0);
  EXPECT_FALSE(robot.look());
}

TEST(LoopOpportunity, AWallIsNoShortcut) {
  Robot robot(40.1);
  for (double y = 0; y < 13; y += 0.05)  // a wall across the way home
    for (double x = -1.2; x < 1.2; x += 0.05)
      if (y > 3 && y < 3.2) robot.map.set(robot.map.cellOf({x, y}), -100);
  EXPECT_FALSE(robot.look());
}

TEST(LoopOpportunity, ADoorNarrowerThanTheRobotIsNoWay) {
  Robot robot(40.1);
  for (double x = -1.2; x < 1.2; x += 0.05)
    if (std::abs(x) > 0.3) robot.map.set(robot.map.cellOf({x, 3.0}), -100);
  OpportunityParams params;
  EXPECT_TRUE(robot.look(params));
  params.robot_radius_m = 0.4;
  EXPECT_FALSE(robot.look(params));
}

TEST(LoopOpportunity, FarByTheGraphMeansMoreThanC2) {
  OpportunityParams params;
  params.c2_m = 45;
  EXPECT_FALSE(Robot(40.1).look(params));
}

TEST(LoopOpportunity, ThePlacesThatDoNotCountAreLeftOut) {
  const Robot robot(40.1);
  const auto found = findOpportunity(robot.graph, robot.map, robot.position, {},
                                     [](const loops::Place& p) { return p.step > 0; });
  if (found) {
    EXPECT_NE(found->entry, 0U);
  }
  EXPECT_FALSE(findOpportunity(robot.graph, robot.map, robot.position, {},
                               [](const loops::Place&) { return false; }));
}

TEST(LoopOpportunity, C1MustBeLessThanC2) {
  OpportunityParams params;
  params.c1_m = 25;
  try {
    loops::validate(params, "loop_closing");
    FAIL();
  } catch (const core::UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("[loop_closing] c1_m = 25"), std::string::npos);
  }
}
