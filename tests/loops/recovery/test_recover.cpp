#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/tiles/tile_pool.h"
#include "filter_drive.h"

using namespace ariadne;
using loops::Draw;
using mrpt::math::TPose2D;
using test::differingCells;
using test::FilterDrive;

namespace {

std::vector<TPose2D> trajectory(const filter::AncestorPtr& leaf) {
  std::vector<TPose2D> poses;
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    poses.push_back(a.pose());
    return true;
  });
  std::reverse(poses.begin(), poses.end());
  return poses;
}

/// The map that the whole trajectory makes, from nothing.
grid::OccupancyGrid fromScratch(const FilterDrive& drive, const filter::AncestorPtr& leaf) {
  grid::OccupancyGrid map(drive.models.grid);
  const auto poses = trajectory(leaf);
  for (std::size_t i = 0; i < poses.size(); ++i) map.insert(drive.shapes[i], poses[i]);
  return map;
}

void expectSamePose(const TPose2D& a, const TPose2D& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(std::remainder(a.phi - b.phi, 2 * M_PI), 0, tolerance);
}

}  // namespace

TEST(Recovery, MapsAreThoseOfARebuildFromScratch) {
  FilterDrive drive(8);
  drive.steps(30);
  const auto saved = drive.save(12);
  drive.steps(20);
  for (const Draw draw : {Draw::independent, Draw::shared, Draw::own_descendant_first}) {
    const auto out = drive.recover(saved, draw);
    ASSERT_EQ(out.particles.size(), 8U);
    for (const auto& p : out.particles) {
      EXPECT_EQ(p.ancestor->step(), 49U);
      EXPECT_EQ(differingCells(p.map, fromScratch(drive, p.ancestor)), 0U);
      for (const auto* c = p.checkpoints.get(); c; c = c->earlier.get())
        EXPECT_EQ(
            differingCells(c->map, fromScratch(drive, filter::ancestorAt(p.ancestor, c->step))), 0U)
            << "checkpoint " << c->step;
    }
  }
}

TEST(Recovery, EntriesKeepTheirPastAndGetTheMotionOfTheirSource) {
  FilterDrive drive(8);
  drive.steps(30);
  const std::size_t te = 12;
  const auto saved = drive.save(te);
  drive.steps(20);
  const auto out = drive.recover(saved);
  for (std::size_t e = 0; e < 8; ++e) {
    const auto& p = out.particles[e];
    EXPECT_EQ(filter::ancestorAt(p.ancestor, te), saved.entries[e].at_te) << "Eq. (11)";
    EXPECT_EQ(out.weights[e], saved.entries[e].weight) << "Eq. (12)";
    const auto mine = trajectory(p.ancestor);
    const auto source = trajectory(drive.set[out.sources[e]].ancestor);
    double increments = 0;
    filter::forEachAncestor(drive.set[out.sources[e]].ancestor, [&](const filter::Ancestor& a) {
      if (a.step() > te) increments += a.logWeight();
      return a.step() > te;
    });
    for (std::size_t k = te + 1; k < mine.size(); ++k)
      expectSamePose(geometry::relativePose(mine[te], mine[k]),
                     geometry::relativePose(source[te], source[k]), 1e-9);
    EXPECT_NEAR(p.accumulated(), saved.entries[e].at_te->accumulated() + increments, 1e-9);
    EXPECT_EQ(out.graphs[e].visits().size(), 50U);
  }
}

TEST(Recovery, WhatWaysShareTheyShareStill) {
  FilterDrive drive(8);
  drive.steps(30);
  const auto saved = drive.save(12);
  drive.steps(20);
  const auto out = drive.recover(saved);
  for (std::size_t step = 12; step < 50; ++step) {
    std::set<std::pair<const filter::Ancestor*, const filter::Ancestor*>> hypotheses;
    std::vector<filter::AncestorPtr> leaves;
    for (std::size_t e = 0; e < 8; ++e) {
      const auto& source = drive.set[out.sources[e]].ancestor;
      // Where ways start there is one hypothesis an entry, whatever its source was at te.
      const auto* at_step = step == 12 ? nullptr : filter::ancestorAt(source, step).get();
      hypotheses.insert({saved.entries[e].at_te.get(), at_step});
      leaves.push_back(out.particles[e].ancestor);
    }
    EXPECT_EQ(filter::distinctAncestors(leaves, step), hypotheses.size()) << "update " << step;
  }
}

TEST(Recovery, AtOnceIsTheIdentity) {
  FilterDrive drive(8);
  drive.steps(25);
  for (const std::size_t te : {24U, 10U}) {
    const auto out = drive.recover(drive.save(te), Draw::own_descendant_first);
    const auto weights = drive.set.weights();
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(out.sources[i], i);
      expectSamePose(out.particles[i].map_from_robot, drive.set[i].map_from_robot, 1e-12);
      EXPECT_NEAR(out.particles[i].accumulated(), drive.set[i].accumulated(), 1e-12);
      EXPECT_EQ(out.weights[i], weights[i]);
      EXPECT_EQ(out.graphs[i].distances(), drive.graphs[i].distances());
      // Poses through te and back differ in the last bit, which may turn a cell at a border.
      EXPECT_LE(differingCells(out.particles[i].map, drive.set[i].map), te == 24 ? 0U : 60U);
    }
  }
}

TEST(Recovery, OfIdenticalEntriesChangesNothingButNames) {
  FilterDrive drive(6);
  drive.steps(20);
  drive.set.replace(std::vector<filter::Particle>(6, drive.set[2]),
                    std::vector<double>(6, 1 / 6.0));
  drive.graphs.assign(6, drive.graphs[2]);
  const auto saved = drive.save(8);
  const filter::Particle before = drive.set[0];
  const auto out = drive.recover(saved);
  for (const auto& p : out.particles) {
    expectSamePose(p.map_from_robot, before.map_from_robot, 1e-12);
    EXPECT_NEAR(p.accumulated(), before.accumulated(), 1e-12);
    EXPECT_LE(differingCells(p.map, before.map), 60U);
    EXPECT_NE(p.ancestor, before.ancestor) << "a new name";
  }
}

TEST(Recovery, MovesWithTheWorldByWholeCells) {
  FilterDrive here(6);
  FilterDrive there(6, {32, -16, 0});
  for (FilterDrive* d : {&here, &there}) d->steps(25);
  const auto a = here.recover([&] {
    auto s = here.save(10);
    here.steps(15);
    return s;
  }());
  const auto b = there.recover([&] {
    auto s = there.save(10);
    there.steps(15);
    return s;
  }());
  EXPECT_EQ(a.sources, b.sources);
  for (std::size_t i = 0; i < 6; ++i) {
    // Measured: poses agree to 1e-13, the maps to the cell.
    expectSamePose({a.particles[i].map_from_robot.x + 32, a.particles[i].map_from_robot.y - 16,
                    a.particles[i].map_from_robot.phi},
                   b.particles[i].map_from_robot, 1e-9);
    EXPECT_LE(differingCells(a.particles[i].map, b.particles[i].map, 512, -256), 60U);
  }
}

TEST(Recovery, TheOrderOfParticlesDoesNotMatter) {
  FilterDrive drive(7);
  drive.steps(25);
  auto saved = drive.save(10);
  const auto straight = drive.recover(saved, Draw::own_descendant_first);

  std::vector<std::size_t> order{3, 0, 6, 1, 5, 2, 4};
  std::vector<filter::Particle> particles;
  std::vector<double> weights;
  std::vector<loops::PlaceGraph> graphs;
  loops::SavedSet shuffled = saved;
  for (std::size_t i = 0; i < 7; ++i) {
    particles.push_back(drive.set[order[i]]);
    weights.push_back(drive.set.weights()[order[i]]);
    graphs.push_back(drive.graphs[order[i]]);
    shuffled.entries[i] = saved.entries[order[i]];
  }
  drive.set.replace(particles, weights);
  drive.graphs = graphs;
  const auto mixed = drive.recover(shuffled, Draw::own_descendant_first);
  for (std::size_t i = 0; i < 7; ++i) {
    expectSamePose(mixed.particles[i].map_from_robot, straight.particles[order[i]].map_from_robot,
                   0);
    EXPECT_EQ(mixed.particles[i].accumulated(), straight.particles[order[i]].accumulated());
    EXPECT_EQ(mixed.weights[i], straight.weights[order[i]]);
  }
}

TEST(Recovery, IsTheSameBitsOnAnyNumberOfThreads) {
  std::vector<loops::RecoveredSet> sets;
  for (const int threads : {1, 2, 8}) {
    FilterDrive drive(8, {}, threads);
    drive.steps(25);
    const auto saved = drive.save(10);
    drive.steps(10);
    sets.push_back(drive.recover(saved));
  }
  for (const auto& other : sets)
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_EQ(other.particles[i].map_from_robot.x, sets[0].particles[i].map_from_robot.x);
      EXPECT_EQ(differingCells(other.particles[i].map, sets[0].particles[i].map), 0U);
    }
}

TEST(Recovery, GivesDiversityBack) {
  FilterDrive drive(16);
  drive.steps(15);
  const auto saved = drive.save(10);
  const std::size_t distinct = saved.distinctAncestors();
  ASSERT_GT(distinct, 4U);
  drive.steps(60);
  const auto out = drive.recover(saved);
  std::vector<filter::AncestorPtr> before;
  std::vector<filter::AncestorPtr> after;
  for (std::size_t i = 0; i < 16; ++i) {
    before.push_back(drive.set[i].ancestor);
    after.push_back(out.particles[i].ancestor);
  }
  EXPECT_EQ(filter::distinctAncestors(after, 10), distinct);
  EXPECT_LT(filter::distinctAncestors(before, 10), distinct);
  for (const double share : out.contradiction) EXPECT_LT(share, 0.1);
}

TEST(Recovery, TheLastHolderFreesTheTiles) {
  std::size_t reserved = 0;
  for (int round = 0; round < 60; ++round) {
    FilterDrive drive(8);
    drive.steps(12);
    auto saved = std::make_unique<loops::SavedSet>(drive.save(10));
    std::vector<std::weak_ptr<const filter::Checkpoint>> watch;
    for (const auto& e : saved->entries) watch.emplace_back(e.checkpoint);
    ASSERT_GT(saved->mapBytes(), 100000U);
    // Nothing but the saved set holds the maps of that time any more.
    drive.set.replace(std::vector<filter::Particle>(8, filter::Particle()),
                      std::vector<double>(8, 0.125));
    saved.reset();
    for (const auto& w : watch) EXPECT_TRUE(w.expired());
    // So the tiles of the next round, over 100 kB, lie where those of the first lay.
    if (round == 0) reserved = grid::TilePool::reserved();
  }
  EXPECT_EQ(grid::TilePool::reserved(), reserved);
}

TEST(Recovery, RefusesATeThatIsNotPast) {
  FilterDrive drive(4);
  drive.steps(5);
  EXPECT_NO_THROW(drive.save(4));
  EXPECT_THROW(drive.save(5), std::out_of_range);
}
