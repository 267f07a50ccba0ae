#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/loops/closing/stop_rules.h"

using namespace ariadne::loops;

namespace {

constexpr double kStep = 0.3;

/// Neff falls by `slope` of its logarithm a metre, from N, with a resampling at N / 2.
ClosingCourse course(double metres, double slope, double start = 30) {
  ClosingCourse c;
  c.loop_length_m = 20;
  c.uncertainty_at_te_m = 0.1;
  double neff = start;
  for (double s = 0; s <= metres; s += kStep) {
    const bool resampled = neff < 15;
    c.steps.push_back({100 + s, neff, 30, resampled, 0.5});
    neff = (resampled ? 30 : neff) * std::exp(-slope * kStep);
  }
  return c;
}

}  // namespace

TEST(StopRules, NeffConstantIsConstant) {
  const StopRule rule = neffConstantFor(10, 0.1);
  EXPECT_TRUE(rule(course(12, 0)));
  EXPECT_TRUE(rule(course(12, 0, 17))) << "its level does not matter";
  EXPECT_FALSE(rule(course(9, 0))) << "not yet for 10 m";
  EXPECT_FALSE(rule(course(12, 0.05)));
  EXPECT_FALSE(rule(ClosingCourse()));
}

TEST(StopRules, AResamplingIsABreakNotInformation) {
  auto flat = course(30, 0);
  EXPECT_TRUE(neffConstantFor(10, 0.1)(flat));
  flat.steps[flat.steps.size() - 10].resampled = true;
  EXPECT_FALSE(neffConstantFor(10, 0.1)(flat));
  EXPECT_TRUE(neffConstantFor(2, 0.1)(flat));
}

TEST(StopRules, TheSlopeIsThatBetweenResamplings) {
  for (const double slope : {0.02, 0.05, 0.2}) {
    const auto c = course(60, slope);
    EXPECT_TRUE(neffFallsLessThan(1.2 * slope, 20)(c)) << slope;
    EXPECT_FALSE(neffFallsLessThan(0.8 * slope, 20)(c)) << slope;
  }
  EXPECT_TRUE(neffFallsLessThan(0.01, 10)(course(12, 0)));
}

TEST(StopRules, AStandingRobotIsNoEnd) {
  ClosingCourse c;
  for (int i = 0; i < 1000; ++i) c.steps.push_back({5, 20, 30, false, 0});
  EXPECT_FALSE(neffConstantFor(10, 0.1)(c));
  EXPECT_FALSE(neffFallsLessThan(0.01, 10)(c));
}

TEST(StopRules, UncertaintyBackToThatAtTheEntry) {
  auto c = course(5, 0);
  EXPECT_FALSE(uncertaintyBackToEntry()(c));
  c.steps.back().uncertainty_m = 0.1;
  EXPECT_TRUE(uncertaintyBackToEntry()(c));
}

TEST(StopRules, LoopsAndLaps) {
  EXPECT_FALSE(loopDriven(1)(course(19, 0.1)));
  EXPECT_TRUE(loopDriven(1)(course(21, 0.1)));
  EXPECT_FALSE(loopDriven(3)(course(59, 0.1)));
  EXPECT_TRUE(loopDriven(3)(course(61, 0.1)));
}

TEST(StopRules, ArmedOnlyAfterADistance) {
  EXPECT_FALSE(armedAfter(20, neffConstantFor(10, 0.1))(course(15, 0)));
  EXPECT_TRUE(armedAfter(20, neffConstantFor(10, 0.1))(course(21, 0)));
}

TEST(StopRules, TheArmDistanceIsTheUncertaintysAndTheWindowNeffs) {
  ClosingParams p;
  auto c = course(12, 0);
  c.uncertainty_at_te_m = 1;
  for (const Stop stop : {Stop::neff, Stop::neff_slope}) {
    p.stop = stop;
    p.arm_distance_m = 15;
    EXPECT_TRUE(stopRule(p)(c)) << "its window of 10 m is driven";
  }
  p.stop = Stop::uncertainty;
  EXPECT_FALSE(stopRule(p)(c));
  p.arm_distance_m = 10;
  EXPECT_TRUE(stopRule(p)(c));
}

TEST(StopRules, ByName) {
  ClosingParams p;
  const auto flat = course(50, 0);
  for (const Stop stop : {Stop::leaving, Stop::never}) {
    p.stop = stop;
    EXPECT_FALSE(stopRule(p)(flat));
  }
  for (const Stop stop : {Stop::neff, Stop::neff_slope, Stop::path_end, Stop::laps}) {
    p.stop = stop;
    EXPECT_TRUE(stopRule(p)(flat));
  }
}
