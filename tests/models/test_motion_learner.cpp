#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/models/motion_learner.h"
#include "ariadne/models/motion_model.h"
#include "ariadne/models/offset_fit.h"

using namespace ariadne;
using models::MotionLearner;
using models::MotionParams;
using mrpt::math::TPose2D;

namespace {

constexpr double kGain = 2;

/// How the odometry of a made-up log is off.
struct Odometry {
  double scatter = 0.2;  // share of the wide widths
  double turn = 0;       // lacking, rad per m
  double stretch = 0;    // lacking, m per m
};

/// Steps of 0.5 m matched by scans of this information (x, y, heading), which see the truth
/// exactly.
MotionLearner learned(const Odometry& odometry, int steps, const Eigen::Vector3d& information) {
  const MotionParams wide;
  MotionLearner learner(wide);
  core::RandomStream rng(5, 0, 0, core::Purpose::test);
  const TPose2D increment(0.5, 0, 0);
  const Eigen::Vector3d sigma = odometry.scatter * models::Motion(increment, wide).sigma();
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector3d truth(0.5 * (1 + odometry.stretch) + sigma[0] * rng.gaussian(),
                                sigma[1] * rng.gaussian(),
                                0.5 * odometry.turn + sigma[2] * rng.gaussian());
    // Where scan and odometry agree best, as the matcher finds it.
    const TPose2D mean = learner.corrected(increment);
    const Eigen::Vector3d believed =
        models::Motion(mean, learner.params()).sigma().cwiseAbs2().cwiseInverse();
    const Eigen::Vector3d scan = kGain * information;
    const Eigen::Vector3d match =
        (believed.cwiseProduct(Eigen::Vector3d(mean.x, mean.y, mean.phi)) +
         scan.cwiseProduct(truth))
            .cwiseQuotient(believed + scan);
    learner.add(increment, {match[0], match[1], match[2]}, {0, 0, 0}, information.asDiagonal(),
                kGain);
  }
  return learner;
}

const Eigen::Vector3d kSharp(1e7, 1e7, 1e9);

}  // namespace

TEST(MotionLearner, StartsAsWideAsItIsTold) {
  const MotionLearner learner{MotionParams()};
  for (const double scale : learner.scales()) EXPECT_EQ(scale, 1);
  EXPECT_EQ(learner.turnPerMetre(), 0);
  EXPECT_EQ(learner.stretch(), 0);
  EXPECT_EQ(learner.params().turn_per_m_deg, MotionParams().turn_per_m_deg);
}

// 1.5 times the true spread is what it takes. A standard deviation over 200 steps scatters by 5 %,
// the four steps that the start counts for make it wider by a quarter here: bounds of three of the
// former.
TEST(MotionLearner, NarrowsToWhatTheLogShows) {
  const auto scales = learned({}, 400, kSharp).scales();
  const double expected = 1.5 * std::sqrt((200 * 0.2 * 0.2 + 4) / 204);
  for (const double scale : scales) EXPECT_NEAR(scale, expected, 0.15 * expected);
}

TEST(MotionLearner, LearnsAConstantTurnAndStretchAndTakesThemOut) {
  const auto learner = learned({0.1, 0.05, -0.03}, 400, kSharp);
  EXPECT_NEAR(learner.turnPerMetre(), 0.05, 0.005);
  EXPECT_NEAR(learner.stretch(), -0.03, 0.003);
  const TPose2D corrected = learner.corrected({2, 0, 0.1});
  EXPECT_NEAR(corrected.phi, 0.1 + 2 * learner.turnPerMetre(), 1e-12);
  EXPECT_NEAR(corrected.x, 2 * (1 + learner.stretch()), 1e-12);
  EXPECT_LT(learner.scales()[2], 0.6);
}

TEST(MotionLearner, ABareCorridorSaysNothingOfTheWayAlongIt) {
  const auto learner = learned({0.1, 0, 0.05}, 200, {1, 1e7, 1e9});
  EXPECT_EQ(learner.scales()[0], 1);
  EXPECT_NEAR(learner.stretch(), 0, 0.005);
  EXPECT_LT(learner.scales()[1], 0.6);
}

TEST(MotionLearner, IsNeverWiderThanItIsTold) {
  for (const double scale : learned({3}, 200, kSharp).scales()) EXPECT_EQ(scale, 1);
}

// Noise of the matches is not taken for the odometry's: exact odometry, matches off by 5 cm. Taken
// for the odometry's it would be a scale of 1; the steps that the start counts for hold 0.5.
TEST(OffsetFit, TellsTheNoiseOfMatchesFromThatOfTheOdometry) {
  models::OffsetFit fit(0.1);
  core::RandomStream rng(7, 0, 0, core::Purpose::test);
  for (int i = 0; i < 400; ++i) fit.add({0.05 * rng.gaussian(), 0.5, 0.05 * 0.05, 0.05 * 0.05});
  EXPECT_LT(fit.scale(), 0.75);
}

TEST(OffsetFit, SlipsCountAsFarAsItTakesThem) {
  models::OffsetFit fit(0.1);
  core::RandomStream rng(8, 0, 0, core::Purpose::test);
  for (int i = 0; i < 400; ++i)
    fit.add({i % 20 == 0 ? 5.0 : 0.01 * rng.gaussian(), 0.5, 0.05 * 0.05, 1e-6});
  // 0.2 and the start's steps without slips.
  EXPECT_LT(fit.scale(), 0.45);
  EXPECT_NEAR(fit.bias(), 0, 0.02);
}
