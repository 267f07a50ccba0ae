// Rawlogs of newer MRPTs: what is known is read, the rest is told, nothing takes the memory.
#include <mrpt/rtti/CObject.h>
#include <sys/resource.h>

#include "rawlog_by_mrpt.h"
#include "rawlog_versions.h"
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples
using ariadne::io::readByMrpt;

namespace {

/// An object as the installed MRPT writes it: 0x80 | length, name, version, body, end flag.
struct Written {
  explicit Written(const mrpt::serialization::CSerializable& object) {
    bytes = Rawlog().add(object).bytes();
    version_at = 1 + (static_cast<unsigned char>(bytes[0]) & 0x7F);
  }
  std::string body() const { return bytes.substr(version_at + 1); }
  int version() const { return bytes[version_at]; }
  /// Of another version, with more bytes at the end of its body.
  std::string as(int other, const std::string& more) const {
    std::string made = bytes;
    made[version_at] = static_cast<char>(other);
    made.insert(made.size() - 1, more);
    return made;
  }
  std::string bytes;
  std::size_t version_at = 0;
};

/// As MRPT 3 writes it: how long a sweep takes, seconds, is new.
std::string scanOfVersion8(double time_s) {
  const float sweep_s = 0.1F;
  return Written(*scan(time_s)).as(8, {reinterpret_cast<const char*>(&sweep_s), sizeof(sweep_s)});
}

/// Of no MRPT yet.
std::string scanOfVersion9(double time_s) {
  return Written(*scan(time_s)).as(9, std::string(40, '\x07'));
}

/// A frame around observations that are bytes already.
std::string frameOf(const std::vector<std::string>& observations) {
  std::string bytes = Rawlog().frame({}).bytes();
  bytes.pop_back();  // the end flag
  bytes[bytes.size() - 4] = static_cast<char>(observations.size());
  for (const std::string& o : observations) bytes += o;
  return bytes + "\x88";
}

long peak_kb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

class RawlogVersions : public TemporaryFolder {
 protected:
  Result readLog(const std::string& bytes) { return readBytes(folder / "a.rawlog", bytes); }
};

TEST_F(RawlogVersions, NoInstalledClassIsNewerThanOurs) {
  for (const auto& known : io::kKnownClasses) {
    const auto* id = mrpt::rtti::findRegisteredClass(std::string(known.name));
    ASSERT_NE(id, nullptr) << known.name;
    const auto object =
        std::dynamic_pointer_cast<mrpt::serialization::CSerializable>(id->createObject());
    ASSERT_TRUE(object) << known.name;
    EXPECT_LE(io::writtenVersion(*object), known.newest)
        << known.name
        << ": MRPT writes a newer version; teach it to libs/io/src/rawlog_objects.cpp "
        << "or rawlog_poses.cpp, then write it into rawlog_versions.h";
  }
}

TEST_F(RawlogVersions, ScansOfMrpt3AreRead) {
  std::string pairs, single;
  for (int i = 0; i < 5; ++i) {
    const std::string s = scanOfVersion8(kBegin_s + i);
    pairs += Rawlog().add(action({0.5, 0, 0})).bytes() + frameOf({s});
    single += Rawlog().add(odometry(kBegin_s + i, {0.5 * i, 0, 0})).bytes() + s;
  }
  for (const std::string& log : {pairs, single}) {
    const Result r = readLog(log);
    ASSERT_EQ(r.steps.size(), 5U) << r.error;
    EXPECT_TRUE(r.warnings.empty()) << r.warnings[0];
    EXPECT_EQ(r.steps[4].scan->getScanSize(), 19U);
    EXPECT_EQ(r.steps[4].scan->getScanRange(3), 1.75F);
    EXPECT_NEAR(r.steps[4].time_s, kBegin_s + 4, 1e-6);
  }
}

TEST_F(RawlogVersions, WhatNobodyKnowsIsPassedOverAndTold) {
  std::string log;
  for (int i = 0; i < 6; ++i) {
    const double time_s = kBegin_s + i;
    log += Rawlog().add(action({0.5, 0, 0})).bytes();
    log += i % 2 == 0 ? frameOf({scanOfVersion9(time_s)})
                      : frameOf({scanOfVersion9(time_s), scanOfVersion8(time_s)});
  }
  const Result r = readLog(log);
  ASSERT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_NEAR(r.steps[2].odom_from_robot.x, 3, 1e-9);  // no motion is lost
  EXPECT_TRUE(r.warns("6 observations passed over: CObservation2DRangeScan of version 9"));
  std::string none;
  for (int i = 0; i < 3; ++i)
    none += Rawlog().add(action({})).bytes() + frameOf({scanOfVersion9(i)});
  const Result error = readLog(none);
  for (const char* part : {"no 2D laser scan", "CObservation2DRangeScan of version 9", "up to 8"})
    EXPECT_NE(error.error.find(part), std::string::npos) << error.error;
}

TEST_F(RawlogVersions, AMovementThatNobodyKnowsEndsTheReading) {
  std::string log = pairsLog(3);
  std::string newer = Rawlog().add(action({0.5, 0, 0})).bytes();
  const std::string name = "CActionRobotMovement2D";
  newer[newer.find(name) + name.size()] = 9;
  const Result r = readLog(log + newer + frameOf({scanOfVersion8(kBegin_s + 9)}));
  EXPECT_EQ(r.steps.size(), 3U) << r.error;
  EXPECT_TRUE(r.warns("cannot be read at entry 6"));
  EXPECT_TRUE(r.warns("CActionRobotMovement2D of version 9"));
}

TEST_F(RawlogVersions, MrptsOwnClassReadsWhatItKnows) {
  auto original = scan(kBegin_s, "front", 7);
  original->setScanHasIntensity(true);
  const Written written(*original);
  const io::ObjectHeader header{"CObservation2DRangeScan", false, written.version()};
  const std::string body = written.body();
  mrpt::obs::CObservation2DRangeScan got;
  EXPECT_EQ(readByMrpt(got, header, body), body.size());
  EXPECT_EQ(got.sensorLabel, "front");
  EXPECT_EQ(got.aperture, original->aperture);
  EXPECT_EQ(got.maxRange, original->maxRange);
  EXPECT_EQ(got.timestamp, original->timestamp);
  ASSERT_EQ(got.getScanSize(), 7U);
  EXPECT_EQ(got.getScanRange(6), original->getScanRange(6));
  // More may follow; less is no object.
  EXPECT_EQ(readByMrpt(got, header, body + std::string(500, '\x88')), body.size());
  EXPECT_EQ(readByMrpt(got, header, body.substr(0, body.size() - 1)), 0U);
  EXPECT_EQ(readByMrpt(got, {header.name, false, 99}, body), 0U);
  const Written reading(odometry(kBegin_s, {1, 2, 0.5}));
  mrpt::obs::CObservationOdometry o;
  EXPECT_EQ(readByMrpt(o, {"CObservationOdometry", false, reading.version()}, reading.body()),
            reading.body().size());
  EXPECT_EQ(o.odometry.x(), 1);
}

TEST_F(RawlogVersions, CountsThatMrptWouldBelieveCostNoMemory) {
  const Written written(*scan(kBegin_s, "front"));
  const io::ObjectHeader header{"CObservation2DRangeScan", false, written.version()};
  const long before_kb = peak_kb();
  std::size_t refused = 0;
  for (std::size_t at = 0; at + 4 <= written.body().size(); ++at)
    for (const std::string claim : {"\xff\xff\xff\xff", "\xff\xff\xff\x7f", "\xff\xff\xff\x0f"}) {
      std::string body = written.body();
      body.replace(at, 4, claim);
      mrpt::obs::CObservation2DRangeScan got;
      refused += readByMrpt(got, header, body) == 0 ? 1 : 0;
    }
  EXPECT_GT(refused, 20U);
  EXPECT_LT(peak_kb() - before_kb, 50'000);
}
