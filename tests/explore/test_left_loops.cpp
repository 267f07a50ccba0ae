#include <gtest/gtest.h>

#include "ariadne/explore/left_loops.h"

using namespace ariadne;
using explore::LeftLoops;

namespace {

grid::OccupancyGrid room(int door) {
  grid::GridParams params;
  params.resolution_m = 0.1;
  grid::OccupancyGrid map(params);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x) map.set({x, y}, 40);
  for (int y = 0; y < 30; ++y) map.set({30, y}, -40);
  for (int y = 10; y < 10 + door; ++y)
    for (int x = 30; x < 40; ++x) map.set({x, y}, 40);
  return map;
}

loops::Closing loopAt(std::size_t name, double x, double y) {
  loops::Closing loop;
  loop.id = name;
  loop.entry_position = {x, y};
  return loop;
}

}  // namespace

TEST(LeftLoops, AnEntryStaysLeftUnderAnyNumberWhileTheMapThereStays) {
  LeftLoops left;
  const auto map = room(0);
  EXPECT_FALSE(left.contains(loopAt(0, 2.5, 1.5)));
  left.add(loopAt(0, 2.5, 1.5), map);
  left.forgetWhereChanged(map);
  left.forgetWhereChanged(room(1));  // a wall's cell or two come and go
  EXPECT_TRUE(left.contains(loopAt(0, 2.5, 1.5)));
  EXPECT_TRUE(left.contains(loopAt(7, 2, 1))) << "the same place";
  EXPECT_FALSE(left.contains(loopAt(7, 0.2, 1))) << "another";
}

TEST(LeftLoops, AnEntryMayBeGoneToAgainWhenTheMapThereHasChanged) {
  LeftLoops left;
  left.add(loopAt(0, 2.5, 1.5), room(0));
  left.forgetWhereChanged(room(10));  // a door has opened
  EXPECT_FALSE(left.contains(loopAt(0, 2.5, 1.5)));
}

TEST(LeftLoops, ALoopThatWasEnteredStaysLeft) {
  LeftLoops left;
  auto loop = loopAt(3, 2.5, 1.5);
  loop.entered = 10;
  left.add(loop, room(0));
  left.forgetWhereChanged(room(10));
  EXPECT_TRUE(left.contains(loop));
  EXPECT_FALSE(left.contains(loopAt(4, 2.5, 1.5))) << "its entry may be gone to";
}
