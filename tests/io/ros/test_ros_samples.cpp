// Recordings that other people's libraries wrote, all of one drive (datasets/ros): each is read to
// the steps of the text that they were made of, and gives the map of the same drive as a rawlog.
#include <fstream>
#include <sstream>

#include "ariadne/io/dataset_writers.h"
#include "ariadne/slam/mapper.h"
#include "ros_log.h"

namespace fs = std::filesystem;
using namespace sample;  // NOLINT: a test of these samples

namespace {

struct DriveStep {
  double time_s = 0;
  TPose2D pose;
  std::vector<float> ranges;
};

std::vector<DriveStep> driveOfText() {
  std::vector<DriveStep> steps;
  std::ifstream text(kRecordings / "drive.txt");
  for (std::string line; std::getline(text, line);) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    DriveStep step;
    std::int64_t time_ns = 0;
    words >> time_ns >> step.pose.x >> step.pose.y >> step.pose.phi;
    step.time_s = static_cast<double>(time_ns / 1000) / 1e6;
    for (std::string word; words >> word;) step.ranges.push_back(std::stof(word));
    steps.push_back(std::move(step));
  }
  return steps;
}

mrpt::maps::COccupancyGridMap2D mapOf(const fs::path& log) {
  ariadne::slam::SlamParams params;
  params.filter.particles = 5;
  ariadne::slam::Mapper mapper(params, 1);
  const auto source = io::openDataset(log);
  while (const auto step = source->next()) mapper.process(*step);
  EXPECT_GT(mapper.updates(), 10U);
  return mapper.map();
}

/// A rawlog of the drive, written by us from the text alone.
void writeDrive(const fs::path& path) {
  const auto steps = driveOfText();
  std::size_t next = 0;
  io::writeObservationRawlog(path, [&]() -> std::optional<ariadne::models::SensorStep> {
    if (next == steps.size()) return std::nullopt;
    const DriveStep& from = steps[next++];
    auto s = mrpt::obs::CObservation2DRangeScan::Create();
    s->timestamp = mrpt::Clock::fromDouble(from.time_s);
    s->aperture = static_cast<float>(M_PI);
    s->maxRange = 6;
    s->sensorPose = mrpt::poses::CPose3D(0.2, 0, 0.25, 0, 0, 0);
    s->resizeScan(from.ranges.size());
    for (std::size_t i = 0; i < from.ranges.size(); ++i) {
      const bool hit = from.ranges[i] < 6;
      s->setScanRange(i, hit ? from.ranges[i] : 6);
      s->setScanRangeValidity(i, hit);
    }
    return ariadne::models::SensorStep{from.time_s, from.pose, s};
  });
}

class Sample : public TemporaryFolder, public testing::WithParamInterface<const char*> {};

}  // namespace

TEST_P(Sample, HoldsTheStepsOfTheText) {
  const Result r = sample::read(kRecordings / GetParam());
  const auto expected = driveOfText();
  ASSERT_EQ(r.error, "");
  EXPECT_EQ(r.label, "/scan");
  for (const std::string& w : r.warnings) ADD_FAILURE() << w;
  ASSERT_EQ(r.steps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto& step = r.steps[i];
    EXPECT_EQ(step.time_s, expected[i].time_s);
    // Half an angle, its sine and back: some roundings.
    EXPECT_EQ(step.odom_from_robot.x, expected[i].pose.x);
    EXPECT_EQ(step.odom_from_robot.y, expected[i].pose.y);
    EXPECT_NEAR(step.odom_from_robot.phi, expected[i].pose.phi, 1e-14);
    const auto& scan = *step.scan;
    EXPECT_EQ(scan.aperture, static_cast<float>(M_PI));
    EXPECT_TRUE(scan.rightToLeft);
    EXPECT_EQ(scan.maxRange, 6);
    EXPECT_EQ(scan.sensorPose, mrpt::poses::CPose3D(0.2, 0, 0.25, 0, 0, 0));
    ASSERT_EQ(scan.getScanSize(), 61U);
    for (std::size_t k = 0; k < 61; ++k) {
      const bool hit = expected[i].ranges[k] < 6;
      EXPECT_EQ(scan.getScanRangeValidity(k), hit);
      EXPECT_EQ(scan.getScanRange(k), hit ? expected[i].ranges[k] : 6);
    }
  }
}

TEST_P(Sample, GivesTheMapOfTheRawlog) {
  writeDrive(folder / "drive.rawlog");
  const auto map = mapOf(kRecordings / GetParam()), expected = mapOf(folder / "drive.rawlog");
  EXPECT_EQ(map.getXMin(), expected.getXMin());
  EXPECT_EQ(map.getYMin(), expected.getYMin());
  EXPECT_EQ(map.getSizeX(), expected.getSizeX());
  EXPECT_EQ(map.getRawMap(), expected.getRawMap());
}

INSTANTIATE_TEST_SUITE_P(RosSamples, Sample,
                         testing::Values("odom.bag", "tf_bz2.bag", "tf.mcap", "odom_plain.mcap",
                                         "odom_zstd.mcap", "tf_lz4.mcap", "ros1_zstd.mcap",
                                         "tf.db3", "split", "split/metadata.yaml", "zstd_messages",
                                         "zstd_file", "zstd_file/drive_0.db3.zstd"),
                         [](const auto& sample_info) {
                           std::string name = sample_info.param;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

// A laser that hangs and scans clockwise has its beams where one that stands and scans the other
// way round has them; the file holds one topic after the other.
TEST(RosSample, HangingClockwiseLaser) {
  const Result r = sample::read(kRecordings / "hanging_lz4.bag");
  const auto expected = driveOfText();
  ASSERT_EQ(r.error, "");
  ASSERT_EQ(r.steps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(r.steps[i].odom_from_robot.x, expected[i].pose.x);
    const auto& scan = *r.steps[i].scan;
    EXPECT_FALSE(scan.rightToLeft);
    for (std::size_t k = 0; k < 61; ++k) {
      const double in_laser = scan.aperture / 2 - M_PI / 60 * static_cast<double>(k);
      const auto end =
          scan.sensorPose.composePoint({10 * std::cos(in_laser), 10 * std::sin(in_laser), 0});
      const double on_robot = -M_PI / 2 + M_PI / 60 * static_cast<double>(k);
      EXPECT_NEAR(end.x, 0.2 + 10 * std::cos(on_robot), 1e-5);
      EXPECT_NEAR(end.y, 10 * std::sin(on_robot), 1e-5);
    }
  }
}
