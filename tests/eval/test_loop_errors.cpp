#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/geometry/pose.h"

using namespace ariadne;

namespace {

/// Twice round a square of 20 m, a pose every 0.2 m.
geometry::Trajectory square() {
  geometry::Trajectory path;
  for (int i = 0; i < 800; ++i) {
    const double s = 0.2 * (i % 400);
    const int side = static_cast<int>(s / 20);
    const double u = s - 20 * side;
    const mrpt::math::TPose2D corner[] = {
        {0, 0, 0}, {20, 0, M_PI / 2}, {20, 20, M_PI}, {0, 20, -M_PI / 2}};
    path.push_back({0.1 * i, geometry::compose(corner[side], {u, 0, 0})});
  }
  return path;
}

}  // namespace

TEST(LoopErrors, APerfectPathIsCorrectInAnyFrame) {
  const auto truth = square();
  geometry::Trajectory moved;
  for (const auto& p : truth) moved.push_back({p.time_s, geometry::compose({5, -3, 1}, p.pose)});
  const auto errors = eval::loopErrors(moved, truth, 0);
  EXPECT_GT(errors.closures.size(), 50U);
  EXPECT_NEAR(errors.worst_translation.translation_m, 0, 1e-9);
  EXPECT_EQ(eval::verdictOf(errors), eval::Verdict::correct);
}

TEST(LoopErrors, AShiftOfTheSecondLapIsFound) {
  const auto truth = square();
  auto path = truth;
  for (std::size_t i = 400; i < path.size(); ++i) path[i].pose.x += 0.7;
  const auto errors = eval::loopErrors(path, truth, 0);
  EXPECT_NEAR(errors.worst_translation.translation_m, 0.7, 1e-9);
  EXPECT_EQ(eval::verdictOf(errors), eval::Verdict::wrong);
  EXPECT_EQ(eval::verdictOf(errors, {0.71, 5}), eval::Verdict::correct);
}

TEST(LoopErrors, TheClosuresAreThoseOfBruteForce) {
  const auto truth = square();
  const eval::LoopParams params;
  const auto errors = eval::loopErrors(truth, truth, 0, params);
  for (const auto& c : errors.closures) {
    const auto& a = truth[c.first].pose;
    const auto& b = truth[c.second].pose;
    EXPECT_LT(std::hypot(a.x - b.x, a.y - b.y), params.near_m);
    EXPECT_GT(0.2 * static_cast<double>(c.second - c.first), params.apart_m - 1e-6);
  }
}

TEST(LoopErrors, APathWithoutALoopHasNoClosure) {
  geometry::Trajectory line;
  for (int i = 0; i < 300; ++i) line.push_back({0.1 * i, {0.2 * i, 0, 0}});
  const auto errors = eval::loopErrors(line, line, 0);
  EXPECT_TRUE(errors.closures.empty());
  EXPECT_EQ(eval::verdictOf(errors), eval::Verdict::no_loop) << "not correct: nothing was judged";
}
