#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/statistics/plan.h"

using namespace ariadne;

// R's manual, ?power.prop.test: power.prop.test(p1 = .50, p2 = .75, power = .90) gives n = 76.7.
TEST(Plan, FormulaIsThatOfRsManual) {
  EXPECT_NEAR(statistics::normalSeeds(0.5, 0.75, {0.9, 0.05}), 76.7, 0.05);
}

// Minitab macro fisherspower of Mathews (MM&B), for Sample Size Calculations (2010), 4.3.2.1: 0.01
// against 0.05, 80 an arm, one-sided at 0.05: 0.211135. With arms of one size the two-sided p-value
// is twice the one-sided, so this is the power at 0.1 less the 2.27e-5 of a difference the wrong
// way.
TEST(Plan, FisherPowerIsThatOfMathews) {
  EXPECT_NEAR(statistics::fisherPower(80, 0.01, 80, 0.05, 0.1), 0.211135 + 2.27e-5, 1e-6);
}

// R package MESS, tests/testthat/testpowermcnemar.R ("validated results").
TEST(Plan, McNemarIsThatOfMess) {
  EXPECT_NEAR(statistics::normalPairs(0.05, 0.45), 22.0, 0.5);
  EXPECT_NEAR(statistics::mcnemarPower(144, 0.25, 0.45), 0.80, 0.005);
}

// 40 % from 93 %: the smallest numbers that reach the goal, both ways round.
TEST(Plan, TellsThePapersRatesApart) {
  const statistics::PlanGoal goal{0.9, 0.05};
  const auto seeds = statistics::planUnpaired(0.4, 0.93, goal);
  EXPECT_TRUE(seeds.exact);
  EXPECT_GE(seeds.power, 0.9);
  EXPECT_EQ(statistics::fisherPower(seeds.runs, 0.4, seeds.runs, 0.93), seeds.power);
  EXPECT_LT(statistics::fisherPower(seeds.runs - 1, 0.4, seeds.runs - 1, 0.93), 0.9);
  EXPECT_EQ(statistics::planUnpaired(0.93, 0.4, goal).runs, seeds.runs);
  const auto pairs = statistics::planPaired(0.4 * 0.07, 0.6 * 0.93, goal);
  EXPECT_GE(pairs.power, 0.9);
  EXPECT_LT(statistics::mcnemarPower(pairs.runs - 1, 0.4 * 0.07, 0.6 * 0.93), 0.9);
}

TEST(Plan, GoesOverToTheFormulas) {
  const auto many = statistics::planUnpaired(0.50, 0.53);
  EXPECT_FALSE(many.exact);
  EXPECT_GT(static_cast<double>(many.runs), statistics::normalSeeds(0.50, 0.53));
  EXPECT_THROW(statistics::planUnpaired(0.5, 0.5), core::UsageError);
  EXPECT_THROW(statistics::planUnpaired(0.5, 1.5), core::Error);
  EXPECT_THROW(statistics::planPaired(0.2, 0.2), core::UsageError);
}
