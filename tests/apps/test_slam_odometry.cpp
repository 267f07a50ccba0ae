// Odometry that jumps or never moves, and scans that show nothing: what a run makes of them, and
// what it says.
#include "ariadne/geometry/pose.h"
#include "slam_sense.h"

using namespace ariadne;
using mrpt::math::TPose2D;

namespace {

/// Counted from (0, 0, 0) from this scan on.
std::function<TPose2D(int, const TPose2D&)> resetAt(int scan) {
  return [=](int i, const TPose2D& p) {
    return i < scan ? p : geometry::relativePose(room_log::pose(scan), p);
  };
}

}  // namespace

class SlamOdometry : public SlamSense {
 protected:
  void mapOf(const char* name, const room_log::Options& options,
             const std::vector<std::string>& more = {}) {
    log = put(std::string(name) + ".log", room_log::text(80, options));
    ASSERT_EQ(map(name, more), 0) << err;
  }
};

// Without a jump the path is up to 0.079 m from the truth (cells of 0.1 m), with one up to 0.085 m.
TEST_F(SlamOdometry, AResetIsNotBelievedAndTold) {
  mapOf("plain", {});
  const auto truth = path("plain", "odometry.tum");
  EXPECT_LT(farthest(path("plain"), truth), 0.1);
  EXPECT_EQ(summary("plain")["checks"]["odometry_jumps"]["count"], 0);
  for (const int scan : {17, 40, 61}) {  // always in a turn: the drive is a circle
    room_log::Options reset;
    reset.odometry = resetAt(scan);
    mapOf("reset", reset, {"--overwrite"});
    EXPECT_EQ(countOf(err, "the odometry jumped 1 times"), 1U) << err;
    EXPECT_EQ(countOf(err, "1 times the scan told where the robot was"), 1U) << err;
    EXPECT_EQ(summary("reset")["checks"]["odometry_jumps"]["told_by_scan"], 1);
    EXPECT_LT(farthest(path("reset"), truth), 0.15) << scan;
  }
}

TEST_F(SlamOdometry, AResetBehindAGapIsNotBelievedEither) {
  mapOf("plain", {});
  room_log::Options gap;
  gap.odometry = resetAt(40);
  gap.stamp = [](int i) { return 1000 + 0.2 * i + (i < 40 ? 0 : 60); };
  mapOf("gap", gap);
  EXPECT_EQ(countOf(err, "the odometry jumped 1 times"), 1U) << err;
  EXPECT_LT(farthest(path("gap"), path("plain", "odometry.tum")), 0.15);
}

TEST_F(SlamOdometry, WhereNothingWasSeenThePathIsTheOdometrys) {
  room_log::Options blind;
  blind.blind = [](int i) { return i >= 20 && i < 60; };
  blind.odometry = [](int i, const TPose2D& p) {  // 4 % of the way are missing
    return TPose2D(p.x - 0.004 * i, p.y, p.phi);
  };
  mapOf("blind", blind);
  EXPECT_EQ(countOf(err, "in 40 of 80 scans hardly a beam returned"), 1U) << err;
  EXPECT_DOUBLE_EQ(summary("blind")["checks"]["blind_scans_share"].get<double>(), 0.5);
  const auto told = path("blind"), odometry = path("blind", "odometry.tum");
  for (std::size_t i = 21; i < 59; ++i) {
    const auto a = geometry::relativePose(told[i - 1].pose, told[i].pose);
    const auto b = geometry::relativePose(odometry[i - 1].pose, odometry[i].pose);
    EXPECT_NEAR(a.x, b.x, 0.02) << i;
    EXPECT_NEAR(a.y, b.y, 0.02) << i;
  }
}

TEST_F(SlamOdometry, OdometryThatNeverMovesIsToldAndScansCanStandIn) {
  mapOf("plain", {});
  room_log::Options still;
  still.odometry = [](int, const TPose2D&) { return TPose2D(); };
  mapOf("still", still);
  EXPECT_EQ(countOf(err, "the odometry stood still while the robot drove by its scans"), 1U) << err;
  EXPECT_NE(err.find("[dataset] odometry = scans"), err.npos) << err;
  EXPECT_GT(summary("still")["checks"]["standing_scans_share"].get<double>(), 0.5);
  mapOf("scans", still, {"--set", "dataset.odometry=scans"});
  EXPECT_EQ(err.find("stood still"), err.npos) << err;
  EXPECT_LT(farthest(path("scans"), path("plain", "odometry.tum")), 0.2);
}

TEST_F(SlamOdometry, InOtherUnitsItIsTold) {
  room_log::Options feet;
  feet.odometry = [](int, const TPose2D& p) { return TPose2D(p.x / 0.3048, p.y / 0.3048, p.phi); };
  mapOf("feet", feet);
  EXPECT_NE(err.find("does the odometry count in other units"), err.npos) << err;
}
