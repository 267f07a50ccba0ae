#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include <cmath>

#include "ariadne/geometry/pose.h"
#include "ariadne/slam/rbpf_map_builder.h"
#include "drive.h"

using namespace ariadne;
using slam::RbpfMapBuilder;

namespace {

mrpt::config::CConfigFileMemory stockIni(const std::string& map) {
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(R"(
[MappingApplication]
insertionLinDistance = 0.4
insertionAngDistance_deg = 20
localizeLinDistance = 0.3
localizeAngDistance_deg = 15
PF_algorithm = 2
adaptiveSampleSize = 0
sampleSize = 10
pfOptimalProposal_mapSelection = 0
BETA = 0.4
resamplingMethod = 3
)" + map + "_count = 1\n[MappingApplication_" +
                 map + R"(_00_creationOpts]
resolution = 0.05
[MappingApplication_)" +
                 map + R"(_00_insertOpts]
maxDistanceInsertion = 12
maxOccupancyUpdateCertainty = 0.65
)");
  return ini;
}

RbpfMapBuilder::TConstructionOptions optionsFrom(const std::string& map = "occupancyGrid") {
  RbpfMapBuilder::TConstructionOptions options;
  options.loadFromConfigFile(stockIni(map), "MappingApplication");
  options.verbosity_level = mrpt::system::LVL_ERROR;
  return options;
}

/// MRPT gives a pointer up to 2.5, a reference later.
[[maybe_unused]] const mrpt::maps::CMultiMetricMap& mapsOf(const mrpt::maps::CMultiMetricMap* m) {
  return *m;
}
[[maybe_unused]] const mrpt::maps::CMultiMetricMap& mapsOf(const mrpt::maps::CMultiMetricMap& m) {
  return m;
}

/// What a program for CMetricMapBuilderRBPF does with each entry of a rawlog.
void feed(mrpt::slam::CMetricMapBuilder& builder, const test::RecordedDrive& drive) {
  mrpt::math::TPose2D last;
  for (const auto& step : drive.steps) {
    mrpt::obs::CActionRobotMovement2D movement;
    movement.poseChange.get_ptr() = mrpt::poses::CPosePDFGaussian::Create(
        mrpt::poses::CPose2D(geometry::relativePose(last, step.odom_from_robot)));
    last = step.odom_from_robot;
    mrpt::obs::CActionCollection action;
    action.insert(movement);
    mrpt::obs::CSensoryFrame frame;
    frame.insert(step.scan);
    builder.processActionObservation(action, frame);
  }
}

}  // namespace

TEST(RbpfMapBuilder, TakesStockOptions) {
  for (const char* map : {"occupancyGrid", "tiledGrid"}) {
    const auto params = optionsFrom(map).resolved();
    EXPECT_EQ(params.filter.particles, 10);
    EXPECT_EQ(params.filter.beta, 0.4);
    EXPECT_EQ(params.filter.resampling, filter::Resampling::systematic);
    EXPECT_EQ(params.filter.proposal, filter::Proposal::improved);
    EXPECT_NEAR(params.update.update_distance_m, 0.3, 1e-6);
    EXPECT_NEAR(params.update.update_angle_deg, 15, 1e-4);
    EXPECT_EQ(params.grid.resolution_m, 0.05);
    EXPECT_EQ(params.grid.insert_range_m, 12);
  }
}

TEST(RbpfMapBuilder, MapsLikeTheMapperBehindIt) {
  const auto drive = test::ovalDrive(80);
  const auto options = optionsFrom();
  RbpfMapBuilder builder(options);
  feed(builder, drive);
  slam::Mapper mapper(options.resolved(), 1);
  for (const auto& step : drive.steps) mapper.process(step);

  EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), mapper.updates());
  const auto grid =
      mapsOf(builder.getCurrentlyBuiltMetricMap()).mapByClass<mrpt::maps::COccupancyGridMap2D>();
  ASSERT_TRUE(grid);
  EXPECT_NEAR(grid->getXMin(), mapper.map().getXMin(), 1e-3);
  std::deque<mrpt::math::TPose3D> path;
  builder.getCurrentMostLikelyPath(path);
  EXPECT_EQ(path.size(), mapper.updates());

  const auto mean = builder.getCurrentPoseEstimation()->getMeanVal();
  const auto end = mapper.path().back().pose;
  EXPECT_LT(std::hypot(mean.x() - end.x, mean.y() - end.y), 0.05);
}

TEST(RbpfMapBuilder, ClearAndInitializeStartAnew) {
  const auto drive = test::ovalDrive(30);
  RbpfMapBuilder builder(optionsFrom());
  feed(builder, drive);
  mrpt::maps::CSimpleMap built;
  builder.getCurrentlyBuiltMap(built);
  EXPECT_GT(built.size(), 3U);
  builder.clear();
  EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), 0U);
  const mrpt::poses::CPosePDFGaussian start(mrpt::poses::CPose2D(3, 4, 0.5));
  builder.initialize(built, &start);
  EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), built.size());
  EXPECT_NEAR(builder.getCurrentPoseEstimation()->getMeanVal().x(), 3, 1e-9);
}

TEST(RbpfMapBuilder, FramesWithoutALaserOnlyMoveTheRobot) {
  RbpfMapBuilder builder(optionsFrom());
  auto drive = test::ovalDrive(5);
  feed(builder, drive);
  const auto size = builder.getCurrentlyBuiltMapSize();
  mrpt::obs::CActionRobotMovement2D movement;
  movement.poseChange.get_ptr() =
      mrpt::poses::CPosePDFGaussian::Create(mrpt::poses::CPose2D(1, 0, 0));
  mrpt::obs::CActionCollection action;
  action.insert(movement);
  mrpt::obs::CSensoryFrame empty;
  const double before = builder.getCurrentPoseEstimation()->getMeanVal().x();
  builder.processActionObservation(action, empty);
  EXPECT_FALSE(builder.m_statsLastIteration.observationsInserted);
  EXPECT_EQ(builder.getCurrentlyBuiltMapSize(), size);
  EXPECT_NEAR(builder.getCurrentPoseEstimation()->getMeanVal().x(), before + 1, 0.05);
}
