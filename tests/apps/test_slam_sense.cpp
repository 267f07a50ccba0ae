// Logs whose clock, odometry or scans do not make sense: what a run makes of them, and what it
// says.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ariadne/io/tum.h"
#include "slam_app_fixture.h"

using namespace ariadne;

class SlamSense : public SlamApp {
 protected:
  nlohmann::json summary(const char* run) const {
    return nlohmann::json::parse(io::readWhole(folder / run / "summary.json"));
  }
  models::Trajectory path(const char* run) const {
    return io::readTum(folder / run / "trajectory.tum");
  }
  static std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
    return n;
  }
};

TEST_F(SlamSense, AClockThatIsSetBackChangesNoPose) {
  room_log::Options set_back;
  set_back.stamp = [](int i) { return i < 3 ? 9e8 + 0.2 * i : 1000 + 0.2 * i; };
  const std::string odd = put("odd.log", room_log::text(40, set_back));
  ASSERT_EQ(map("plain"), 0) << err;
  log = odd;
  ASSERT_EQ(map("odd"), 0) << err;
  EXPECT_EQ(countOf(err, "the clock was set back"), 1U) << err;
  const auto json = summary("odd");
  EXPECT_EQ(json["dataset"]["scans"], 40);
  EXPECT_NEAR(json["dataset"]["duration_s"].get<double>(), 7.6, 1e-6);
  auto plain = path("plain");
  auto other = path("odd");  // sorted by time: the first three are last
  ASSERT_EQ(other.size(), plain.size());
  std::rotate(other.begin(), other.end() - 3, other.end());
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(other[i].pose, plain[i].pose) << i;
}

TEST_F(SlamSense, TruthIsFoundByTheLogsOwnStamps) {
  room_log::Options set_back;
  set_back.stamp = [](int i) { return i < 10 ? 9e8 + 0.2 * i : 1000 + 0.2 * i; };
  log = put("odd.log", room_log::text(40, set_back));
  ASSERT_EQ(map("first"), 0) << err;
  ASSERT_EQ(map("second", {"--truth", (folder / "first/trajectory.tum").string()}), 0) << err;
  EXPECT_LT(summary("second")["ate_rmse_m"].get<double>(), 1e-8);
}

TEST_F(SlamSense, StampsThatRunBackwardsAreAnError) {
  room_log::Options backwards;
  backwards.stamp = [](int i) { return 1000 - 0.2 * i; };
  log = put("back.log", room_log::text(40, backwards));
  EXPECT_EQ(map("back"), 1);
  EXPECT_NE(err.find("39 of 40 scans have stamps that neither"), std::string::npos) << err;
}
