#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/loops/recovery/saved_stack.h"
#include "filter_drive.h"

using namespace ariadne;
using loops::SavedStack;

TEST(SavedStack, PoppingAnOuterOneDropsWhatIsAbove) {
  test::FilterDrive drive(4);
  drive.steps(12);
  SavedStack stack(1000);
  for (std::size_t name = 0; name < 3; ++name)
    EXPECT_TRUE(stack.push(name, drive.save(2 + name)).empty());
  const auto middle = stack.pop(1);
  ASSERT_TRUE(middle);
  EXPECT_EQ(middle->te, 3U);
  EXPECT_TRUE(stack.holds(0));
  EXPECT_FALSE(stack.holds(2));
  EXPECT_FALSE(stack.pop(1));
}

TEST(SavedStack, AnInnerRecoveryLeavesTheOuterSetUsable) {
  test::FilterDrive drive(6);
  drive.steps(30);
  SavedStack stack(1000);
  stack.push(0, drive.save(4));
  drive.steps(10);
  stack.push(1, drive.save(20));
  drive.steps(10);
  auto inner = drive.recover(*stack.pop(1));
  drive.set.replace(std::move(inner.particles), inner.weights);
  drive.graphs = std::move(inner.graphs);
  drive.steps(10);
  const auto outer = stack.pop(0);
  ASSERT_TRUE(outer);
  const auto out = drive.recover(*outer);
  for (std::size_t e = 0; e < 6; ++e) {
    EXPECT_EQ(filter::ancestorAt(out.particles[e].ancestor, 4), outer->entries[e].at_te);
    EXPECT_EQ(out.particles[e].ancestor->step(), 59U);
    grid::OccupancyGrid scratch(drive.models.grid);
    std::vector<const filter::Ancestor*> line;
    filter::forEachAncestor(out.particles[e].ancestor, [&](const filter::Ancestor& a) {
      line.push_back(&a);
      return true;
    });
    for (auto it = line.rbegin(); it != line.rend(); ++it)
      scratch.insert(drive.shapes[(*it)->step()], (*it)->pose());
    EXPECT_EQ(test::differingCells(out.particles[e].map, scratch), 0U);
  }
}

TEST(SavedStack, TheBudgetDropsTheOldestAndSaysSo) {
  test::FilterDrive drive(4);
  drive.steps(12);
  SavedStack all(1000);
  all.push(0, drive.save(1));
  const double one = all.megabytes();
  all.push(1, drive.save(11));
  const double both = all.megabytes();
  SavedStack second(1000);
  second.push(1, drive.save(11));
  const double larger = std::max(one, second.megabytes());
  ASSERT_GT(both, larger);
  SavedStack tight((larger + both) / 2);
  EXPECT_TRUE(tight.push(0, drive.save(1)).empty());
  EXPECT_EQ(tight.push(1, drive.save(11)), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(tight.holds(1));
}

TEST(SavedStack, ASetBiggerThanTheBudgetIsNotHeld) {
  test::FilterDrive drive(4);
  drive.steps(12);
  SavedStack stack(0.001);
  EXPECT_EQ(stack.push(7, drive.save(5)), (std::vector<std::size_t>{7}));
  EXPECT_FALSE(stack.holds(7));
  EXPECT_EQ(stack.size(), 0U);
}
