#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/poses/CPosePDFGaussian.h>
#include <mrpt/poses/CPosePDFParticles.h>
#include <mrpt/poses/CPosePDFSOG.h>
#include <zlib.h>

#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class RawlogReader : public TemporaryFolder {
 protected:
  Result readLog(const std::string& bytes, const std::string& label = "") {
    return readBytes(folder / "a.rawlog", bytes, label);
  }
};

TEST_F(RawlogReader, AddsUpTheIncrementsOfPairs) {
  const Result r = readLog(pairsLog(30));
  ASSERT_EQ(r.steps.size(), 30U) << r.error;
  TPose2D expected;
  for (std::size_t i = 0; i < 30; ++i) {
    if (i > 0) expected = expected + TPose2D(0.5, 0, 0.1);
    const auto& step = r.steps[i];
    EXPECT_NEAR(step.time_s, kBegin_s + 0.2 * static_cast<double>(i), 1e-6);
    EXPECT_NEAR(step.odom_from_robot.x, expected.x, 1e-9);
    EXPECT_NEAR(step.odom_from_robot.y, expected.y, 1e-9);
    EXPECT_NEAR(std::remainder(step.odom_from_robot.phi - expected.phi, 2 * M_PI), 0, 1e-9);
  }
  EXPECT_TRUE(r.warnings.empty());
}

TEST_F(RawlogReader, KeepsTheScanAsMrptWroteIt) {
  auto original = scan(kBegin_s, "front", 7);
  original->rightToLeft = false;
  original->deltaPitch = 0.01;
  original->setScanHasIntensity(true);
  original->sensorPose = mrpt::poses::CPose3D(0.1, -0.2, 0.3, 0.4, 0, M_PI);
  const Result r = readLog(Rawlog().add(action({})).frame({original}).bytes());
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  const auto& got = *r.steps[0].scan;
  EXPECT_EQ(got.sensorLabel, "front");
  EXPECT_EQ(got.aperture, original->aperture);
  EXPECT_EQ(got.maxRange, original->maxRange);
  EXPECT_EQ(got.rightToLeft, false);
  EXPECT_EQ(got.deltaPitch, original->deltaPitch);
  EXPECT_EQ(got.timestamp, original->timestamp);
  EXPECT_LT((got.sensorPose - original->sensorPose).norm(), 1e-12);
  EXPECT_NEAR(got.sensorPose.roll(), original->sensorPose.roll(), 1e-9);
  ASSERT_EQ(got.getScanSize(), 7U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(got.getScanRange(i), original->getScanRange(i));
    EXPECT_TRUE(got.getScanRangeValidity(i));
  }
}

TEST_F(RawlogReader, InterpolatesReadingsAtTheScansTime) {
  const Result r = readLog(observationsLog(20));
  ASSERT_EQ(r.steps.size(), 20U) << r.error;
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_NEAR(r.steps[i].odom_from_robot.x, 0.5 * static_cast<double>(i) + 0.25, 1e-5);
  EXPECT_TRUE(r.warnings.empty());
}

TEST_F(RawlogReader, InterpolatesTheShortWayRound) {
  Rawlog log;
  log.add(odometry(kBegin_s, {0, 0, 3.1})).add(*scan(kBegin_s + 0.5));
  log.add(odometry(kBegin_s + 1, {0, 0, -3.1}));
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 1U) << r.error;
  EXPECT_NEAR(std::abs(r.steps[0].odom_from_robot.phi), M_PI, 1e-5);
}

TEST_F(RawlogReader, CountsScansFarFromAnyReading) {
  Rawlog log;
  log.add(odometry(kBegin_s, {0, 0, 0})).add(*scan(kBegin_s + 5));
  log.add(odometry(kBegin_s + 10, {1, 0, 0})).add(*scan(kBegin_s + 10.5)).add(*scan(kBegin_s + 20));
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_NEAR(r.steps[0].odom_from_robot.x, 0.5, 1e-6);
  EXPECT_NEAR(r.steps[2].odom_from_robot.x, 1, 1e-6);
  EXPECT_EQ(r.counts.odometry_gaps, 2U);
}

TEST_F(RawlogReader, PassesOverWhatItDoesNotKnow) {
  mrpt::obs::CObservationComment comment;
  comment.text = std::string(100'000, 'C') + "CObservation CSensoryFrame";
  const auto other = std::make_shared<mrpt::obs::CObservationIMU>(imu());
  Rawlog log;
  log.add(comment).add(imu());
  for (int i = 0; i < 3; ++i) {
    auto actions = action({0.5, 0, 0});
    actions.insert(mrpt::obs::CActionRobotMovement3D());
    const auto s = scan(kBegin_s + i);
    log.add(actions).frame({other, s}).add(imu());
    log.add(action({0.5, 0, 0})).frame({other, scan(kBegin_s + i + 0.5), other});
    log.frame({}).frame({other});
  }
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 6U) << r.error;
  EXPECT_NEAR(r.steps[5].odom_from_robot.x, 3, 1e-9);
  EXPECT_TRUE(r.warnings.empty());
}

TEST_F(RawlogReader, ReadsAWholeCRawlogObject) {
  mrpt::obs::CRawlog whole;
  for (int i = 0; i < 3; ++i) {
    auto actions = action({0.5, 0, 0});
    mrpt::obs::CSensoryFrame frame;
    frame.insert(scan(kBegin_s + i));
    whole.insert(actions);
    whole.insert(frame);
  }
  EXPECT_EQ(readLog(Rawlog().add(whole).bytes()).steps.size(), 3U);
}

TEST_F(RawlogReader, TakesTheMeanOfAnyDensityAndPrefersMatching) {
  const mrpt::poses::CPose2D mean(0.3, 0.1, 0.2);
  const mrpt::poses::CPosePDFGaussian gaussian(mean);
  mrpt::poses::CPosePDFParticles particles(50);
  particles.resetDeterministic(mean.asTPose());
  mrpt::poses::CPosePDFSOG sog(1);
  sog[0].mean = mean;
  const std::vector<const mrpt::poses::CPosePDF*> densities = {&gaussian, &particles, &sog};
  Rawlog log;
  for (std::size_t i = 0; i < densities.size(); ++i) {
    auto actions = action({5, 5, 1});
    mrpt::obs::CActionRobotMovement2D matched;
    matched.estimationMethod = mrpt::obs::CActionRobotMovement2D::emScan2DMatching;
    matched.poseChange =
        std::dynamic_pointer_cast<mrpt::poses::CPosePDF>(densities[i]->duplicateGetSmartPtr());
    actions.insert(matched);
    log.add(actions).frame({scan(kBegin_s + static_cast<double>(i))});
  }
  mrpt::obs::CActionRobotMovement2D sampled;  // MRPT rereads it as random particles
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmThrun;
  sampled.computeFromOdometry(mean, model);
  mrpt::obs::CActionCollection actions;
  actions.insert(sampled);
  log.add(actions).frame({scan(kBegin_s + 3)});
  const Result r = readLog(log.bytes());
  ASSERT_EQ(r.steps.size(), 4U) << r.error;
  TPose2D expected;
  for (const auto& step : r.steps) {
    expected = expected + mean.asTPose();
    EXPECT_NEAR(step.odom_from_robot.x, expected.x, 1e-6);
    EXPECT_NEAR(step.odom_from_robot.phi, expected.phi, 1e-6);
  }
}

TEST_F(RawlogReader, ReadsCompressedAndPlainAlike) {
  const std::string bytes = pairsLog(20);
  gzFile file = gzopen((folder / "b.rawlog").c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  EXPECT_EQ(readLog(bytes).steps.size(), 20U);
  EXPECT_EQ(read(folder / "b.rawlog").steps.size(), 20U);
}

TEST_F(RawlogReader, ReadsMrptsSampleAsMrptDoes) {
  if (!std::filesystem::exists(kMrptSample)) GTEST_SKIP() << "package mrpt-common is missing";
  mrpt::obs::CRawlog reference;
  ASSERT_TRUE(reference.loadFromRawLogFile(kMrptSample));
  const Result r = read(kMrptSample);
  mrpt::poses::CPose2D odometry;
  std::size_t next = 0;
  for (const auto& entry : reference) {
    if (const auto actions = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(entry))
      odometry += actions->getBestMovementEstimation()->poseChange->getMeanVal();
    const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(entry);
    const auto s = frame ? frame->getObservationByClass<mrpt::obs::CObservation2DRangeScan>()
                         : mrpt::obs::CObservation2DRangeScan::Ptr();
    if (!s) continue;
    ASSERT_LT(next, r.steps.size());
    const auto& step = r.steps[next++];
    EXPECT_EQ(step.scan->timestamp, s->timestamp);
    EXPECT_NEAR(step.odom_from_robot.x, odometry.x(), 1e-6);
    EXPECT_NEAR(step.odom_from_robot.y, odometry.y(), 1e-6);
    ASSERT_EQ(step.scan->getScanSize(), s->getScanSize());
    for (std::size_t i = 0; i < s->getScanSize(); ++i)
      EXPECT_EQ(step.scan->getScanRangeValidity(i), s->getScanRangeValidity(i));
  }
  EXPECT_EQ(next, r.steps.size());
}

TEST_F(RawlogReader, ReadsHeadersOfBeforeMrpt055) {
  // No end flags, and a name's length and the version are 32 bit numbers.
  std::string bytes;
  const auto put = [&](auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  const auto header = [&](const std::string& name, std::int32_t version) {
    put(static_cast<std::uint32_t>(name.size()));
    bytes += name;
    put(version);
  };
  for (int i = 0; i < 3; ++i) {
    header("CActionCollection", 0);
    put(std::uint32_t{1});
    header("CActionRobotMovement2D", 4);
    put(std::int32_t{0});
    header("CPose2D", 0);
    for (const float v : {0.5F, 0.0F, 0.1F}) put(v);
    bytes.append(48, '\0');             // the motion model
    bytes.append(1 + 8 + 1 + 8, '\0');  // velocities, encoders
    header("CSensorialFrame", 1);
    put(std::uint32_t{0});
    put(std::uint32_t{2});
    header("CObservationImage", 3);
    bytes.append(5000, '\x11');
    header("CObservation2DRangeScan", 3);
    put(3.0F);
    put(std::uint8_t{1});
    put(30.0F);
    header("CPose3D", 0);
    header("CMatrix", 0);
    put(std::uint32_t{4});
    put(std::uint32_t{4});
    for (int k = 0; k < 16; ++k) put(k % 5 == 0 ? 1.0F : k == 3 ? 0.2F : 0.0F);
    header("CMatrix", 0);
    put(std::uint64_t{0});
    put(std::uint32_t{3});
    for (const float range : {1.0F, 2.0F, 3.0F}) put(range);
    bytes.append(3, '\x01');
    put(0.01F);
    put(std::int64_t{130'000'000'000'000'000} + i);
  }
  const Result r = readLog(bytes);
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_NEAR(r.steps[0].odom_from_robot.x, 0.5, 1e-6);
  EXPECT_NEAR(r.steps[2].odom_from_robot.phi, 0.3, 1e-6);
  EXPECT_NEAR(r.steps[2].scan->sensorPose.x(), 0.2, 1e-6);
  EXPECT_EQ(r.steps[2].scan->getScanRange(2), 3);
  EXPECT_TRUE(r.warnings.empty());
}
