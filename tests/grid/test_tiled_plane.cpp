#include <gtest/gtest.h>

#include <map>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/grid/tiles/tiled_plane.h"

using ariadne::grid::TiledPlane;
using Plane = TiledPlane<std::int8_t>;

TEST(TiledPlane, HoldsWhatWasSetAnywhere) {
  ariadne::core::RandomStream rng(1, 0, 0, ariadne::core::Purpose::test);
  std::map<std::pair<int, int>, std::int8_t> reference;
  Plane plane;
  for (int i = 0; i < 3000; ++i) {
    const int x = static_cast<int>(2000 * rng.gaussian());
    const int y = static_cast<int>(2000 * rng.gaussian());
    const auto value = static_cast<std::int8_t>(rng.bits() % 255 - 127);
    plane.set(x, y, value);
    reference[{x, y}] = value;
  }
  for (const auto& [cell, value] : reference) EXPECT_EQ(plane.at(cell.first, cell.second), value);
  EXPECT_EQ(plane.at(1000000, 5), 0);
}

TEST(TiledPlane, NegativeCellsHaveTheirOwnTiles) {
  Plane plane;
  plane.set(-1, -1, 5);
  plane.set(0, 0, 6);
  EXPECT_EQ(plane.at(-1, -1), 5);
  EXPECT_EQ(plane.at(0, 0), 6);
  EXPECT_EQ(plane.at(31, 31), 0);
  EXPECT_EQ(plane.at(-32, -32), 0);
}

TEST(TiledPlane, ACopyKeepsItsCells) {
  Plane a;
  a.set(3, 4, 1);
  Plane b = a;
  b.set(3, 4, 2);
  b.set(600, 600, 3);  // grows the table of the copy only
  EXPECT_EQ(a.at(3, 4), 1);
  EXPECT_EQ(a.at(600, 600), 0);
  EXPECT_EQ(b.at(3, 4), 2);
}

TEST(TiledPlane, CopiesShareTilesThatNobodyWrote) {
  Plane a;
  a.set(0, 0, 1);
  a.set(100, 0, 1);
  Plane b = a;
  b.set(0, 0, 2);
  EXPECT_NE(a.tile(0, 0), b.tile(0, 0));
  EXPECT_EQ(a.tile(3, 0), b.tile(3, 0));
}

TEST(TiledPlane, ARunawayCellIsAnErrorNotAllMemory) {
  Plane plane;
  plane.set(0, 0, 1);
  EXPECT_THROW(plane.set(2000000000, 2000000000, 1), ariadne::core::Error);
  EXPECT_EQ(plane.at(0, 0), 1);
}
