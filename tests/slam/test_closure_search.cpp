#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/slam/mapper.h"
#include "corridor.h"

using namespace ariadne;
using mrpt::math::TPose2D;
using slam::Mapper;
using slam::SlamParams;

namespace {

constexpr std::size_t kOn = 70;  // updates on the second lap: past a corner

struct Way {
  std::vector<models::SensorStep> steps;
  std::vector<TPose2D> truth;
};

/// Once round the corridor and 35 m on, with odometry that turns 0.08 degrees too far per metre.
const Way& drifting() {
  static const Way made = [] {
    Way way;
    way.truth = test::corridorDrive(0.5);
    for (std::size_t k = 0; k < kOn; ++k) way.truth.push_back(way.truth[k]);
    const test::CorridorWorld world(3);
    core::RandomStream rng(3, 0, 0, core::Purpose::test);
    TPose2D odom = way.truth[0];
    for (std::size_t k = 0; k < way.truth.size(); ++k) {
      if (k > 0) {
        TPose2D step = geometry::relativePose(way.truth[k - 1], way.truth[k]);
        step.phi += 0.08 * M_PI / 180 * std::hypot(step.x, step.y);
        odom = geometry::compose(odom, step);
      }
      way.steps.push_back(
          {1000.0 + static_cast<double>(k), odom,
           mrpt::obs::CObservation2DRangeScan::Create(world.scan(way.truth[k], rng))});
    }
    return way;
  }();
  return made;
}

/// A filter that believes its odometry: it drifts as that does.
SlamParams believing(bool search) {
  SlamParams p;
  p.filter.particles = 6;
  p.filter.proposal = filter::Proposal::odometry;
  p.filter.weight_gain = 1e-4;
  p.motion = {false, 0.01, 0.05, 0.005, 0.001, 0.005, 0.01, 0.001};
  p.loop_closing.search = search;
  p.loop_closing.cooldown_m = 1000;  // recovery is tested elsewhere
  return p;
}

/// Error of the last pose seen from the place one lap before, m.
double errorAcrossTheLoop(const Mapper& mapper) {
  const auto path = mapper.path();
  const std::size_t last = path.size() - 1, before = last - (drifting().steps.size() - kOn);
  const auto found = geometry::relativePose(path[before].pose, path[last].pose);
  const auto truth = geometry::relativePose(drifting().truth[before], drifting().truth[last]);
  return std::hypot(found.x - truth.x, found.y - truth.y);
}

}  // namespace

TEST(ClosureSearch, ClosesALoopThatNoParticleCloses) {
  Mapper plain(believing(false), 1);
  Mapper searching(believing(true), 1);
  for (const auto& step : drifting().steps) {
    plain.process(step);
    searching.process(step);
    if (!searching.foundClosures().empty()) break;  // from there on it drifts again
  }
  EXPECT_TRUE(plain.foundClosures().empty());
  EXPECT_GT(errorAcrossTheLoop(plain), 1);
  ASSERT_FALSE(searching.foundClosures().empty());
  EXPECT_LT(errorAcrossTheLoop(searching), 0.4);
  EXPECT_GT(searching.foundClosures()[0].correction_m, 1);
}

TEST(ClosureSearch, SameBitsOnAnyNumberOfThreads) {
  Mapper one(believing(true), 1);
  Mapper four(believing(true), 4);
  for (const auto& step : drifting().steps) {
    one.process(step);
    four.process(step);
  }
  ASSERT_FALSE(one.foundClosures().empty());
  const auto a = one.path();
  const auto b = four.path();
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].pose.x, b[k].pose.x);
    EXPECT_EQ(a[k].pose.phi, b[k].pose.phi);
  }
  EXPECT_EQ(one.particles().weights(), four.particles().weights());
}

TEST(ClosureSearch, DrawsEveryHypothesisAWayOfItsOwn) {
  Mapper mapper(believing(true), 1);
  for (const auto& step : drifting().steps) {
    mapper.process(step);
    if (!mapper.foundClosures().empty()) break;
  }
  ASSERT_FALSE(mapper.foundClosures().empty());
  for (std::size_t i = 1; i < mapper.particles().size(); ++i)
    EXPECT_NE(mapper.particles()[i].map_from_robot.x, mapper.particles()[0].map_from_robot.x);
}
