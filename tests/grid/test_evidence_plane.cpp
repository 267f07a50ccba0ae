// The packed plane against the plainest one: a byte a cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <thread>

#include "../../libs/grid/src/tiles/tile_mask.h"
#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/grid/tiles/evidence_plane.h"

using namespace ariadne;
using grid::EvidencePlane;
using grid::kTileCells;
using grid::TileMask;

namespace {

core::RandomStream stream(std::uint64_t seed) { return {seed, 0, 0, core::Purpose::test}; }

/// Bits set with a probability of 1/2, 1/16 or all but 1/32; sometimes all.
TileMask randomMask(core::RandomStream& rng) {
  TileMask mask;
  const auto kind = rng.bits() % 8;
  for (auto& row : mask.rows) {
    const auto word = [&] { return static_cast<std::uint32_t>(rng.bits()); };
    if (kind == 0) row = ~0U;
    if (kind == 1 || kind == 2) row = word() & word() & word() & word();
    if (kind == 3 || kind == 4) row = ~(word() & word() & word() & word() & word());
    if (kind > 4) row = word();
  }
  return mask;
}

/// One tile of bytes, on which everything is done cell by cell.
struct PlainTile {
  std::array<int, kTileCells * kTileCells> cells{};

  /// Box of the cells that ceased to be occupied.
  grid::CellBox addFree(const TileMask& mask, int amount) {
    grid::CellBox box{kTileCells, kTileCells, 0, 0};
    for (int i = 0; i < kTileCells * kTileCells; ++i) {
      const int x = i % kTileCells;
      const int y = i / kTileCells;
      if ((mask.rows[y] >> x & 1U) == 0) continue;
      const int before = cells[i];
      cells[i] = std::min(before + amount, 127);
      if (before < 0 && cells[i] >= 0)
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
               std::max(box.y1, y + 1)};
    }
    return box;
  }
};

void expectSame(const EvidencePlane& plane, int tx, int ty, const PlainTile& plain) {
  const auto* tile = plane.tile(tx, ty);
  EvidencePlane::Cells cells{};
  if (tile) cells = plane.cellsOf(*tile);
  for (int y = 0; y < kTileCells; ++y) {
    std::uint32_t free = 0;
    std::uint32_t occupied = 0;
    for (int x = 0; x < kTileCells; ++x) {
      const int value = plain.cells[grid::tileOffset(x, y)];
      ASSERT_EQ(plane.at(tx * kTileCells + x, ty * kTileCells + y), value) << x << ", " << y;
      ASSERT_EQ(cells[grid::tileOffset(x, y)], value) << x << ", " << y;
      free |= static_cast<std::uint32_t>(value > 0) << x;
      occupied |= static_cast<std::uint32_t>(value < 0) << x;
    }
    ASSERT_EQ(tile ? tile->freeRow(y) : 0, free);
    ASSERT_EQ(tile ? tile->occupiedRow(y) : 0, occupied);
  }
}

class EvidencePlaneOf : public testing::TestWithParam<int> {};

}  // namespace

TEST_P(EvidencePlaneOf, EqualsBytesWhateverHappens) {
  const int free = GetParam();
  constexpr int kOccupied = 35;
  constexpr int kTx = -3;
  constexpr int kTy = 20;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    auto rng = stream(seed);
    EvidencePlane plane(static_cast<std::int8_t>(free));
    PlainTile plain;
    for (int i = 0; i < 300; ++i) {
      const EvidencePlane copy = plane;
      const PlainTile before = plain;
      const int x = static_cast<int>(rng.bits() % kTileCells);
      const int y = static_cast<int>(rng.bits() % kTileCells);
      int& value = plain.cells[grid::tileOffset(x, y)];
      const auto kind = rng.bits() % 16;
      if (kind < 8) {
        const TileMask mask = randomMask(rng);
        std::vector<grid::CellBox> freed;
        plane.addFree(kTx, kTy, mask, freed);
        const grid::CellBox box = plain.addFree(mask, free);
        ASSERT_EQ(freed.size(), box.empty() ? 0 : 1);
        if (!freed.empty()) {
          ASSERT_EQ(freed[0].x0, kTx * kTileCells + box.x0);
          ASSERT_EQ(freed[0].y0, kTy * kTileCells + box.y0);
          ASSERT_EQ(freed[0].x1, kTx * kTileCells + box.x1);
          ASSERT_EQ(freed[0].y1, kTy * kTileCells + box.y1);
        }
      } else if (kind < 14) {
        const int was = value;
        value = std::max(was - kOccupied, -127);
        std::vector<grid::Cell> turned;
        plane.addHits({{kTx * kTileCells + x, kTy * kTileCells + y}}, kOccupied, turned);
        ASSERT_EQ(turned.size(), was >= 0 && value < 0 ? 1U : 0U);
      } else if (kind == 14) {
        value = static_cast<int>(rng.bits() % 256) - 128;
        plane.set(kTx * kTileCells + x, kTy * kTileCells + y, static_cast<std::int8_t>(value));
      } else {
        EvidencePlane::Cells cells;
        std::copy(plain.cells.begin(), plain.cells.end(), cells.begin());
        plane.setCells(kTx, kTy, cells);
      }
      expectSame(plane, kTx, kTy, plain);
      expectSame(copy, kTx, kTy, before);
      if (HasFatalFailure()) FAIL() << "seed " << seed << ", step " << i << ", kind " << kind;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Evidence, EvidencePlaneOf,
                         testing::Values(1, 2, 10, 16, 63, 64, 126, 127));

TEST(EvidencePlane, HoldsWhatWasSetAnywhere) {
  auto rng = stream(1);
  std::map<std::pair<int, int>, std::int8_t> reference;
  EvidencePlane plane(10);
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

// Cells of many tiles in any order, some named again.
TEST(EvidencePlane, ManyHitsAreThoseOneByOne) {
  auto rng = stream(5);
  EvidencePlane plane(10);
  std::map<std::pair<int, int>, int> reference;
  for (int round = 0; round < 20; ++round) {
    const EvidencePlane copy = plane;
    std::vector<grid::Cell> cells;
    std::vector<grid::Cell> expected;
    std::vector<grid::Cell> turned;
    for (int i = 0; i < 200; ++i) {
      const grid::Cell c{static_cast<int>(rng.bits() % 90) - 40,
                         static_cast<int>(rng.bits() % 70) - 30};
      int& value = reference[{c.x, c.y}];
      if (rng.bits() % 8 == 0) {
        value = 20;
        plane.set(c.x, c.y, 20);
      }
      cells.push_back(c);
    }
    for (const grid::Cell c : cells) {
      int& value = reference[{c.x, c.y}];
      if (value >= 0 && value < 35) expected.push_back(c);
      value = std::max(value - 35, -127);
    }
    plane.addHits(cells, 35, turned);
    for (const auto& [cell, value] : reference) ASSERT_EQ(plane.at(cell.first, cell.second), value);
    ASSERT_EQ(turned.size(), expected.size());
    for (std::size_t i = 0; i < turned.size(); ++i) {
      EXPECT_EQ(turned[i].x, expected[i].x);
      EXPECT_EQ(turned[i].y, expected[i].y);
    }
  }
}

TEST(EvidencePlane, ATileIsWrittenToOnlyWhenACellChanges) {
  EvidencePlane plane(10);
  auto rng = stream(2);
  TileMask mask = randomMask(rng);
  mask.rows[3] = 0;
  std::vector<grid::CellBox> freed;
  for (int i = 0; i < 13; ++i) plane.addFree(0, 0, mask, freed);  // 13 times 10: as free as can be
  const EvidencePlane copy = plane;
  plane.addFree(0, 0, mask, freed);
  EXPECT_EQ(plane.tile(0, 0), copy.tile(0, 0));
  plane.set(3, 3, -35);
  EXPECT_NE(plane.tile(0, 0), copy.tile(0, 0));
  EXPECT_EQ(copy.at(3, 3), 0);
}

// Also where a beam ended in it once, and many went through since.
TEST(EvidencePlane, OpenFloorTakesNoMemory) {
  EvidencePlane a(10);
  EvidencePlane b(10);
  TileMask all;
  all.rows.fill(~0U);
  std::vector<grid::CellBox> freed;
  b.set(5, 5, -35);
  for (int i = 0; i < 17; ++i) {
    a.addFree(0, 0, all, freed);
    b.addFree(0, 0, all, freed);
  }
  EXPECT_EQ(a.tile(0, 0), b.tile(0, 0));
  EXPECT_EQ(a.tile(0, 0)->sharedCount(), 13);
  ASSERT_EQ(freed.size(), 1);
}

TEST(EvidencePlane, ATileTakesWhatItsCountsNeed) {
  EvidencePlane plane(10);
  auto rng = stream(3);
  TileMask mask = randomMask(rng);
  mask.rows[0] = 1;
  std::vector<grid::CellBox> freed;
  plane.addFree(0, 0, mask, freed);
  EXPECT_LE(plane.tile(0, 0)->bytes(), 16 + 128);
  for (int i = 0; i < 20; ++i) plane.addFree(0, 0, mask, freed);
  EXPECT_LE(plane.tile(0, 0)->bytes(), 16 + 4 * 128);
}

// Run under the tsan preset this is also a race detector.
TEST(EvidencePlane, CopiesAreWrittenToFromManyThreads) {
  auto rng = stream(4);
  EvidencePlane first(10);
  std::vector<grid::CellBox> freed;
  first.addFree(0, 0, randomMask(rng), freed);
  first.set(7, 7, -35);
  const TileMask mask = randomMask(rng);
  EvidencePlane expected = first;
  for (int i = 0; i < 40; ++i) expected.addFree(0, 0, mask, freed);
  std::vector<EvidencePlane> copies(8, first);
  first.clear();
  std::vector<std::thread> threads;
  for (auto& copy : copies)
    threads.emplace_back([&copy, &mask] {
      std::vector<grid::CellBox> boxes;
      for (int i = 0; i < 40; ++i) copy.addFree(0, 0, mask, boxes);
    });
  for (auto& t : threads) t.join();
  for (const auto& copy : copies)
    EXPECT_EQ(copy.cellsOf(*copy.tile(0, 0)), expected.cellsOf(*expected.tile(0, 0)));
}

TEST(EvidencePlane, ARunawayCellIsAnErrorNotAllMemory) {
  EvidencePlane plane(10);
  plane.set(0, 0, 1);
  EXPECT_THROW(plane.set(2000000000, 2000000000, 1), core::Error);
  EXPECT_EQ(plane.at(0, 0), 1);
}
