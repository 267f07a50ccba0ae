#include <mrpt/obs/CRawlog.h>

#include "ariadne/io/dataset_writers.h"
#include "temporary_folder.h"
#include "walled_log.h"

using namespace sample;  // NOLINT: a test of these samples

class DatasetWriters : public TemporaryFolder {
 protected:
  static io::NextStep from(io::StepSource& source) {
    return [&source] { return source.next(); };
  }
  /// The same steps, up to the place where odometry begins.
  static void expectSame(const Result& a, const Result& b) {
    ASSERT_EQ(a.error, "");
    ASSERT_EQ(a.steps.size(), b.steps.size()) << b.error;
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
      const auto& s = a.steps[i];
      const auto& t = b.steps[i];
      EXPECT_NEAR(s.time_s, t.time_s, 3e-7);
      const TPose2D moved_a = s.odom_from_robot - a.steps[0].odom_from_robot;
      const TPose2D moved_b = t.odom_from_robot - b.steps[0].odom_from_robot;
      EXPECT_NEAR(moved_a.x, moved_b.x, 1e-6);
      EXPECT_NEAR(moved_a.y, moved_b.y, 1e-6);
      EXPECT_NEAR(std::remainder(moved_a.phi - moved_b.phi, 2 * M_PI), 0, 1e-7);
      ASSERT_EQ(s.scan->getScanSize(), t.scan->getScanSize());
      EXPECT_NEAR(s.scan->aperture, t.scan->aperture, 1e-5);
      EXPECT_NEAR(s.scan->sensorPose.x(), t.scan->sensorPose.x(), 1e-6);
      EXPECT_NEAR(s.scan->sensorPose.yaw(), t.scan->sensorPose.yaw(), 1e-6);
      for (std::size_t k = 0; k < s.scan->getScanSize(); ++k) {
        ASSERT_EQ(s.scan->getScanRangeValidity(k), t.scan->getScanRangeValidity(k));
        if (s.scan->getScanRangeValidity(k)) {
          ASSERT_EQ(s.scan->getScanRange(k), t.scan->getScanRange(k));
        }
      }
    }
  }
};

TEST_F(DatasetWriters, CarmenToRawlogToCarmen) {
  io::writeWhole(folder / "a.log", carmenLog(30));
  EXPECT_EQ(io::writeRawlog(folder / "b.rawlog", from(*io::openDataset(folder / "a.log"))), 30U);
  const Result original = read(folder / "a.log");
  expectSame(original, read(folder / "b.rawlog"));
  for (const char* name : {"c.log", "c.log.gz"}) {
    EXPECT_EQ(io::writeCarmen(folder / name, from(*io::openDataset(folder / "b.rawlog"))), 30U);
    expectSame(original, read(folder / name));
  }
  io::writeCarmen(folder / "d.log", from(*io::openDataset(folder / "b.rawlog")),
                  io::CarmenLaser::flaser);
  expectSame(original, read(folder / "d.log"));
  EXPECT_EQ(read(folder / "d.log").label, "FLASER");
}

TEST_F(DatasetWriters, AHalfDegreeFanSurvives) {
  std::string text;
  for (int i = 0; i < 10; ++i)
    text += flaser(180, "3.21", fmt::format("{} 0 0", i), fmt::format("{} 0 0", i), kBegin_s + i);
  io::writeWhole(folder / "a.log", text);
  const Result original = read(folder / "a.log");
  for (const auto kind : {io::CarmenLaser::robotlaser, io::CarmenLaser::flaser}) {
    io::writeCarmen(folder / "b.log", from(*io::openDataset(folder / "a.log")), kind);
    expectSame(original, read(folder / "b.log"));
  }
}

TEST_F(DatasetWriters, WhatMeansNoReturnStaysSo) {
  Laser laser;
  laser.reach_m = 8;
  laser.nothing = {8.183F, 8.191F};
  io::writeWhole(folder / "a.rawlog",
                 walledLog(room(30, 20), driveAlong({{-9, -4}, {9, -4}, {9, 4}, {-9, 4}}), laser));
  const Result original = read(folder / "a.rawlog");
  ASSERT_NEAR(original.counts.no_return_from_m, 8.183, 1e-6) << original.error;
  const auto open = [&] { return io::openDataset(folder / "a.rawlog"); };
  io::writeRawlog(folder / "b", from(*open()));
  io::writeObservationRawlog(folder / "c", from(*open()));
  io::writeCarmen(folder / "d", from(*open()));
  io::writeCarmen(folder / "e", from(*open()), io::CarmenLaser::flaser);
  for (const char* name : {"b", "c", "d", "e"}) {
    const Result copy = read(folder / name);
    expectSame(original, copy);
    EXPECT_EQ(copy.counts.beams_no_return, original.counts.beams_no_return) << name;
    EXPECT_EQ(copy.counts.beams_over_reach, 0U) << name;
  }
}

TEST_F(DatasetWriters, MrptReadsOurRawlog) {
  io::writeWhole(folder / "a.log", carmenLog(5));
  io::writeRawlog(folder / "b.rawlog", from(*io::openDataset(folder / "a.log")));
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile((folder / "b.rawlog").string()));
  ASSERT_EQ(log.size(), 10U);
  EXPECT_EQ(log.getType(0), mrpt::obs::CRawlog::etActionCollection);
  EXPECT_EQ(log.getType(1), mrpt::obs::CRawlog::etSensoryFrame);
  const auto motion = log.getAsAction(2)->getBestMovementEstimation();
  EXPECT_NEAR(motion->poseChange->getMeanVal().norm(), 0.5, 1e-9);
}

TEST_F(DatasetWriters, SingleObservationsComeBackToTheBit) {
  std::vector<ariadne::models::SensorStep> steps;
  for (int i = 0; i < 50; ++i) {
    ariadne::models::SensorStep step;
    step.time_s = std::round(i / 3.0 * 1e7) / 1e7;
    step.odom_from_robot = {0.1 * i / 3, -1.7 / (i + 1), std::remainder(0.37 * i, 2 * M_PI)};
    step.scan = scan(step.time_s);
    step.scan->timestamp = mrpt::Clock::fromDouble(step.time_s + 2e-8);  // it cuts off
    steps.push_back(step);
  }
  std::size_t next = 0;
  io::writeObservationRawlog(folder / "a.rawlog", [&] {
    return next < steps.size() ? std::optional(steps[next++]) : std::nullopt;
  });
  const Result r = read(folder / "a.rawlog");
  ASSERT_EQ(r.steps.size(), steps.size()) << r.error;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(r.steps[i].time_s, steps[i].time_s);
    EXPECT_EQ(r.steps[i].odom_from_robot, steps[i].odom_from_robot) << i;
    EXPECT_EQ(r.steps[i].scan->timestamp, steps[i].scan->timestamp);
  }
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile((folder / "a.rawlog").string()));
  EXPECT_EQ(log.size(), 100U);
  EXPECT_EQ(log.getType(0), mrpt::obs::CRawlog::etObservation);
}

TEST_F(DatasetWriters, TheSampleSurvivesTheRoundTrip) {
  if (!std::filesystem::exists(kMrptSample)) GTEST_SKIP() << "package mrpt-common is missing";
  io::writeCarmen(folder / "a.log", from(*io::openDataset(kMrptSample)));
  io::writeRawlog(folder / "b.rawlog", from(*io::openDataset(folder / "a.log")));
  expectSame(read(kMrptSample), read(folder / "b.rawlog"));
}

TEST_F(DatasetWriters, ALaserUpsideDownIsTurnedRound) {
  Rawlog log;
  for (int i = 0; i < 5; ++i) {
    auto s = scan(kBegin_s + i);
    s->sensorPose = mrpt::poses::CPose3D(0.1, 0, 0.5, 0.2, 0, M_PI);
    log.add(action({0.1, 0, 0})).frame({s});
  }
  io::writeWhole(folder / "a.rawlog", log.bytes());
  io::writeCarmen(folder / "b.log", from(*io::openDataset(folder / "a.rawlog")));
  const Result r = read(folder / "b.log");
  ASSERT_EQ(r.steps.size(), 5U) << r.error;
  EXPECT_EQ(r.steps[0].scan->getScanRange(0), 1.0F + 0.25F * 18);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.yaw(), 0.2, 1e-6);
  EXPECT_NEAR(r.steps[0].scan->sensorPose.roll(), 0, 1e-6);
}

TEST_F(DatasetWriters, FlaserRefusesAnotherFan) {
  auto s = scan(kBegin_s);
  s->aperture = 4.7F;
  io::writeWhole(folder / "a.rawlog", Rawlog().add(action({})).frame({s}).bytes());
  EXPECT_THROW(io::writeCarmen(folder / "b.log", from(*io::openDataset(folder / "a.rawlog")),
                               io::CarmenLaser::flaser),
               ariadne::core::Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.log"));
}

TEST_F(DatasetWriters, NamesAPathThatCannotBeWritten) {
  io::writeWhole(folder / "a.log", carmenLog(5));
  for (const char* path : {"missing/b.rawlog", "."}) {
    try {
      io::writeRawlog(folder / path, from(*io::openDataset(folder / "a.log")));
      FAIL();
    } catch (const ariadne::core::Error& e) {
      EXPECT_NE(std::string(e.what()).find("cannot write"), std::string::npos) << e.what();
    }
  }
}

TEST_F(DatasetWriters, AFullDiskIsAnError) {
  // /dev/full takes no byte; the writer's buffers hide that until they are flushed.
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  io::writeWhole(folder / "a.log", carmenLog(5));
  const auto temporary = folder / (".b." + io::writerMark() + ".part.rawlog");
  std::filesystem::create_symlink("/dev/full", temporary);
  EXPECT_THROW(io::writeRawlog(folder / "b.rawlog", from(*io::openDataset(folder / "a.log"))),
               ariadne::core::Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.rawlog"));
}
