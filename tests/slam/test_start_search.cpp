#include <gtest/gtest.h>

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/slam/mapper.h"
#include "ariadne/slam/start_search.h"
#include "drive.h"

using namespace ariadne;
using mrpt::math::TPose2D;
using Result = slam::StartSearch::Result;

namespace {

slam::SlamParams ofFourParticles() {
  slam::SlamParams params;
  params.filter.particles = 4;
  return params;
}

/// One lap of a drive, mapped; a second drive of other noise begins at step `from`.
class StartSearch : public ::testing::Test {
 protected:
  void SetUp() override {
    slam::Mapper mapper(ofFourParticles(), 1);
    const auto lap = test::ovalDrive(110);
    for (const auto& step : lap.steps) mapper.process(step);
    known_ = mapper.simpleMap();
    // The map's frame is that of the first scan.
    for (const TPose2D& p : next_.truth)
      truth_.push_back(geometry::relativePose(next_.truth.front(), p));
  }
  slam::StartSearch search(std::size_t from, const std::optional<TPose2D>& given = {},
                           std::size_t most = 1000) {
    const auto next = [&, k = from, end = from + most]() mutable {
      return k < next_.steps.size() && k < end ? std::optional(next_.steps[k++]) : std::nullopt;
    };
    return slam::searchStart(ofFourParticles(), 1, known_, next, given);
  }
  /// Of the place that was found, m and rad. The map itself is true to 5 cm and a degree.
  void expectAt(const slam::StartSearch& found, std::size_t step) {
    const TPose2D off = geometry::relativePose(truth_[step], found.best.map_from_robot);
    EXPECT_LT(std::hypot(off.x, off.y), 0.12);
    EXPECT_LT(std::abs(off.phi), 0.04);
  }

  test::RecordedDrive next_ = test::ovalDrive(200, 7);
  std::vector<TPose2D> truth_;
  mrpt::maps::CSimpleMap known_;
};

}  // namespace

TEST_F(StartSearch, FindsAnyPlaceOfTheMap) {
  for (const std::size_t from : {20, 55}) {
    const auto found = search(from);
    EXPECT_EQ(found.result, Result::found) << from << ": " << found.best.field;
    expectAt(found, from);
  }
  // From here the 10 m show the walls almost alone, which fit turned round, too: the place is right
  // and yet not taken.
  const auto doubtful = search(80);
  EXPECT_EQ(doubtful.result, Result::ambiguous);
  expectAt(doubtful, 80);
}

TEST_F(StartSearch, AGivenStartIsMadeExact) {
  TPose2D rough = truth_[55];
  rough.x += 0.6;
  rough.y -= 0.5;
  rough.phi += 0.2;
  const auto found = search(55, rough);
  EXPECT_EQ(found.result, Result::found);
  expectAt(found, 55);
}

TEST_F(StartSearch, AWrongStartIsTold) {
  TPose2D wrong = truth_[55];
  wrong.phi += M_PI / 2;
  EXPECT_EQ(search(55, wrong).result, Result::unlike);
}

TEST_F(StartSearch, AStartOutsideTheMapIsTakenAsItIs) {
  const auto found = search(55, TPose2D(40, 0, 1));
  EXPECT_EQ(found.result, Result::unmapped);
  EXPECT_EQ(found.best.map_from_robot.x, 40);
}

TEST_F(StartSearch, AnotherBuildingFitsNowhere) {
  // The same drive, seen by a laser whose readings are a third too long.
  for (auto& step : next_.steps) {
    auto scan = mrpt::obs::CObservation2DRangeScan::Create(*step.scan);
    for (std::size_t k = 0; k < scan->getScanSize(); ++k)
      scan->setScanRange(k, scan->getScanRange(k) * 1.33F);
    step.scan = scan;
  }
  EXPECT_EQ(search(55).result, Result::unlike);
}

TEST_F(StartSearch, ABareRoomLooksTheSameFromBothEnds) {
  mrpt::maps::COccupancyGridMap2D room(-6, 6, -4, 4, 0.02f);
  room.fill(0.9f);
  for (double x = -4; x < 4; x += 0.02)
    for (const double y : {-2.5, 2.5}) room.setPos(x + 0.01, y + 0.01, 0.0f);
  for (double y = -2.5; y < 2.5; y += 0.02)
    for (const double x : {-4.0, 4.0}) room.setPos(x + 0.01, y + 0.01, 0.0f);
  const auto laps = test::ovalDrive(110);
  slam::Mapper mapper(ofFourParticles(), 1);
  for (std::size_t k = 0; k < laps.steps.size(); ++k)
    mapper.process(
        {laps.steps[k].time_s, laps.steps[k].odom_from_robot, test::scanIn(room, laps.truth[k])});
  known_ = mapper.simpleMap();
  for (std::size_t k = 0; k < next_.steps.size(); ++k)
    next_.steps[k].scan = test::scanIn(room, next_.truth[k]);
  const auto found = search(55);
  ASSERT_EQ(found.result, Result::ambiguous) << found.best.field;
  ASSERT_TRUE(found.rival);
  const double turn = found.rival->map_from_robot.phi - found.best.map_from_robot.phi;
  EXPECT_NEAR(std::abs(std::remainder(turn, 2 * M_PI)), M_PI, 0.1);
}

TEST_F(StartSearch, NoScanToGoByIsAnError) { EXPECT_THROW(search(0, {}, 0), core::Error); }
