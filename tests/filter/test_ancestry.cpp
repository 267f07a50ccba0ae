#include <gtest/gtest.h>

#include "ariadne/filter/ancestry.h"
#include "ariadne/filter/particle.h"

using ariadne::filter::Ancestor;
using ariadne::filter::AncestorPtr;
using ariadne::filter::earlierPasses;

namespace {

AncestorPtr lineThrough(const std::vector<double>& xs) {
  AncestorPtr leaf;
  for (std::size_t i = 0; i < xs.size(); ++i)
    leaf = std::make_shared<Ancestor>(leaf, i, mrpt::math::TPose2D(xs[i], 0, 0), 0.5);
  return leaf;
}

}  // namespace

TEST(Ancestry, WalksFromTheLeafToTheRoot) {
  const auto leaf = lineThrough({0, 1, 2, 3});
  std::vector<std::size_t> steps;
  forEachAncestor(leaf, [&](const Ancestor& a) {
    steps.push_back(a.step());
    return a.step() != 1;
  });
  EXPECT_EQ(steps, (std::vector<std::size_t>{3, 2, 1}));
}

TEST(Ancestry, SharedUntilTheLastDescendantGoes) {
  auto parent = std::make_shared<Ancestor>(nullptr, 0, mrpt::math::TPose2D(), 0);
  const std::weak_ptr<Ancestor> watch = parent;
  AncestorPtr a = std::make_shared<Ancestor>(parent, 1, mrpt::math::TPose2D(), 0);
  AncestorPtr b = std::make_shared<Ancestor>(parent, 1, mrpt::math::TPose2D(), 0);
  parent.reset();
  a.reset();
  EXPECT_FALSE(watch.expired());
  b.reset();
  EXPECT_TRUE(watch.expired());
}

TEST(Ancestry, ALongLineIsFreedWithoutRecursion) {
  AncestorPtr leaf;
  for (std::size_t i = 0; i < 1000000; ++i)
    leaf = std::make_shared<Ancestor>(leaf, i, mrpt::math::TPose2D(), 0);
  leaf.reset();  // would overflow the stack
  EXPECT_EQ(leaf, nullptr);
}

// As a long log with checkpoint_updates = 1 makes it.
TEST(Checkpoints, ALongLineIsFreedWithoutRecursion) {
  using ariadne::filter::Checkpoint;
  const ariadne::grid::OccupancyGrid map;
  std::shared_ptr<const Checkpoint> last;
  for (std::size_t i = 0; i < 200000; ++i) last = std::make_shared<Checkpoint>(i, map, last);
  const auto shared = last->earlier;
  last.reset();
  EXPECT_EQ(shared->step, 199998U) << "what somebody else holds stays";
}

TEST(EarlierPasses, CountsSeparateVisitsNotSteps) {
  EXPECT_EQ(earlierPasses(nullptr, 1), 0U);
  EXPECT_EQ(earlierPasses(lineThrough({0, 0.3, 0.6}), 1), 0U);
  EXPECT_EQ(earlierPasses(lineThrough({0, 3, 6, 3, 0.2}), 1), 1U);
  EXPECT_EQ(earlierPasses(lineThrough({0, 0.1, 0.2, 5, 0, 5, 0.1}), 1), 2U);
}
