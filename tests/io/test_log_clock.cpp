// Clocks that were set back or start over, beside single stamps that are wrong.
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class LogClock : public TemporaryFolder {
 protected:
  /// Scan i stands at x = i / 10 on the line itself.
  Result readLines(const std::vector<double>& stamps) {
    std::string text;
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      const std::string pose = fmt::format("{} 0 0", 0.1 * static_cast<double>(i));
      text += flaser(181, "2.5", pose, pose, stamps[i]);
    }
    return readBytes(folder / "a.log", text);
  }
  /// All scans come, in their order and with their own stamps, and one line tells of the clock.
  static void expectAll(const Result& r, const std::vector<double>& stamps, std::size_t set_backs) {
    ASSERT_EQ(r.error, "");
    ASSERT_EQ(r.steps.size(), stamps.size());
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      EXPECT_NEAR(r.steps[i].time_s, stamps[i], 1e-6) << i;
      EXPECT_NEAR(r.steps[i].odom_from_robot.x, 0.1 * static_cast<double>(i), 1e-6) << i;
    }
    EXPECT_EQ(r.counts.scans_backwards, 0U);
    EXPECT_EQ(r.counts.scan_clock.count, set_backs);
    ASSERT_EQ(r.warnings.size(), set_backs > 0 ? 1U : 0U);
    if (set_backs > 0) {
      EXPECT_NE(r.warnings[0].find(fmt::format("set back {} times", set_backs)), std::string::npos)
          << r.warnings[0];
    }
  }
  /// `count` stamps, 0.2 s apart.
  static std::vector<double> stamps(double begin_s, int count) {
    std::vector<double> out;
    for (int i = 0; i < count; ++i) out.push_back(begin_s + 0.2 * i);
    return out;
  }
  static std::vector<double> joined(std::vector<std::vector<double>> parts) {
    std::vector<double> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
  }
};

TEST_F(LogClock, SetBackBy30YearsAfterThreeScans) {
  const auto all = joined({stamps(2.5e9, 3), stamps(1.5e9, 27)});
  const Result r = readLines(all);
  expectAll(r, all, 1);
  EXPECT_NEAR(r.counts.scan_clock.from_s, 2.5e9 + 0.4, 1e-6);
  EXPECT_NEAR(r.counts.scan_clock.to_s, 1.5e9, 1e-6);
}

TEST_F(LogClock, StartsOver) {
  const auto all = joined({stamps(0, 300), stamps(0, 300)});
  expectAll(readLines(all), all, 1);
}

TEST_F(LogClock, SetBackALittle) {
  const auto all = joined({stamps(100, 20), stamps(103.3, 20)});  // from 103.8
  expectAll(readLines(all), all, 1);
}

TEST_F(LogClock, SetBackTwiceAndForwardOnce) {
  const auto all = joined({stamps(500, 10), stamps(400, 10), stamps(9000, 10), stamps(0, 10)});
  expectAll(readLines(all), all, 2);
}

TEST_F(LogClock, TwoWrongStampsAheadCostNothing) {
  const auto all = joined({stamps(10, 5), stamps(9000, 2), stamps(11.4, 30)});
  expectAll(readLines(all), all, 1);
}

TEST_F(LogClock, SetBackBeforeTheLastTwoScans) {
  const auto all = joined({stamps(100, 8), stamps(50, 2)});
  expectAll(readLines(all), all, 1);
}

TEST_F(LogClock, OneScanBehindIsStillDropped) {
  const Result last = readLines({1, 2, 3, 4, 0.5});
  EXPECT_EQ(last.steps.size(), 4U);
  EXPECT_EQ(last.counts.scans_backwards, 1U);
  const Result two = readLines({1, 2, 3, 4, 1.5, 2.5, 5, 6, 7});
  EXPECT_EQ(two.counts.scan_clock.count, 1U);  // two that agree are a clock's
  EXPECT_EQ(two.steps.size(), 9U);
  const Result first = readLines({9000, 1, 2, 3});
  EXPECT_EQ(first.steps.size(), 3U);
  EXPECT_EQ(first.counts.scans_backwards, 1U);
}

TEST_F(LogClock, RunsBackwards) {
  std::vector<double> back;
  for (int i = 0; i < 40; ++i) back.push_back(100 - 0.2 * i);
  EXPECT_NE(readLines(back).error.find("39 of 40 scans have stamps that neither go on"),
            std::string::npos);
  // Beyond what is read before the first step: known at the end.
  std::vector<double> all = stamps(0, 2500);
  for (int i = 0; i < 2600; ++i) all.push_back(40 - 0.01 * i);
  const Result r = readLines(all);
  EXPECT_EQ(r.steps.size(), 2500U);
  EXPECT_NE(r.error.find("2600 of 5100 scans"), std::string::npos) << r.error;
}

TEST_F(LogClock, OfIncrements) {
  Rawlog log;
  const auto all = joined({stamps(2.5e9, 3), stamps(1.5e9, 30)});
  for (std::size_t i = 0; i < all.size(); ++i)
    log.add(action({i == 0 ? 0 : 0.1, 0, 0})).frame({scan(all[i])});
  expectAll(readBytes(folder / "a.rawlog", log.bytes()), all, 1);
}

namespace {

/// Readings every 0.05 s, a scan after each fourth, of a robot that drives 1 m/s. At `at_s` of true
/// time the clock is set back for what comes after.
std::string readingsLog(double odometry_at_s, double scans_at_s, double by_s) {
  Rawlog log;
  for (int i = 0; i < 400; ++i) {
    const double true_s = 0.05 * i;
    const auto stamp = [&](double at_s, double time_s) {
      return kBegin_s + time_s - (time_s >= at_s ? by_s : 0);
    };
    log.add(odometry(stamp(odometry_at_s, true_s), {true_s, 0, 0}));
    if (i % 4 == 3 && i < 396) log.add(*scan(stamp(scans_at_s, true_s + 0.02)));
  }
  return log.bytes();
}

void expectAlongTheWay(const Result& r, double bound_m) {
  ASSERT_EQ(r.error, "");
  ASSERT_EQ(r.steps.size(), 99U);
  for (std::size_t i = 0; i < r.steps.size(); ++i)
    EXPECT_NEAR(r.steps[i].odom_from_robot.x, 0.17 + 0.2 * static_cast<double>(i),
                i == 49 ? 0.05 : bound_m)  // between two readings of different epochs: the nearer
        << i;
}

}  // namespace

TEST_F(LogClock, OfReadings) {
  for (const double by_s : {1.5, 4.0, 1e8}) {
    const Result r = readBytes(folder / "a.rawlog", readingsLog(10, 10, by_s));
    expectAlongTheWay(r, by_s < 1e6 ? 1e-5 : 1e-4);  // as exact as stamps of 1e-7 s are
    EXPECT_EQ(r.counts.scan_clock.count, 1U);
    EXPECT_EQ(r.counts.odometry_clock.count, 1U);
    EXPECT_EQ(r.warnings.size(), 1U);
    EXPECT_EQ(r.counts.odometry_gaps, 0U);
  }
}

// The scan at the seam is of the one epoch or of the other.
TEST_F(LogClock, OfReadingsBetweenReadingAndScan) {
  for (const double at_s : {9.96, 9.99, 10.16, 10.18}) {
    const Result r = readBytes(folder / "a.rawlog", readingsLog(at_s, at_s, 4));
    expectAlongTheWay(r, 0.05);
    EXPECT_EQ(r.counts.odometry_gaps, 0U);
  }
}

// With two clocks only the place in the file says which reading belongs to a scan: the next ones,
// which the gate of stamps holds back for a while, are up to 0.1 m away.
TEST_F(LogClock, OfTheLaserAlone) {
  const Result r = readBytes(folder / "a.rawlog", readingsLog(1e9, 10, 1e6));
  expectAlongTheWay(r, 0.1);
  EXPECT_EQ(r.counts.odometry_gaps, 49U);
  EXPECT_TRUE(r.warns("49 scans are over 1 s away"));
}
