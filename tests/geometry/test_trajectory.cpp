#include <gtest/gtest.h>

#include "ariadne/geometry/trajectory.h"

using namespace ariadne::geometry;

TEST(Trajectory, DurationGoesOnWhereTheClockWasSetBack) {
  EXPECT_EQ(durationOf({}), 0);
  EXPECT_EQ(durationOf({{7, {}}}), 0);
  EXPECT_DOUBLE_EQ(durationOf({{5, {}}, {6.5, {}}, {6.5, {}}, {9, {}}}), 4);
  EXPECT_DOUBLE_EQ(durationOf({{500, {}}, {502, {}}, {1, {}}, {2, {}}, {0, {}}, {4, {}}}), 7);
}

TEST(Trajectory, SortedByTimeKeepsTheOrderOfEqualStamps) {
  const Trajectory sorted = sortedByTime({{3, {1, 0, 0}}, {1, {2, 0, 0}}, {3, {3, 0, 0}}});
  ASSERT_EQ(sorted.size(), 3U);
  EXPECT_EQ(sorted[0].pose.x, 2);
  EXPECT_EQ(sorted[1].pose.x, 1);
  EXPECT_EQ(sorted[2].pose.x, 3);
}

TEST(Trajectory, LengthIsThatOfAllLegs) {
  EXPECT_EQ(lengthOf({}), 0);
  EXPECT_EQ(lengthOf({{7, {1, 2, 3}}}), 0);
  EXPECT_DOUBLE_EQ(lengthOf({{0, {0, 0, 0}}, {1, {3, 4, 1}}, {2, {3, 4, 2}}, {3, {3, 3, 2}}}), 6);
}

