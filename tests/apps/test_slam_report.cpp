// report.html and the true path.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "../report/replay_fixture.h"
#include "../shipped_datasets.h"
#include "ariadne/io/tum.h"
#include "slam_app_fixture.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;
using nlohmann::json;

namespace {

class SlamReport : public SlamApp {
 protected:
  json page(const char* name) const {
    return ariadne::test::dataOf(readWhole(folder / name / "report.html"));
  }
  json summary(const char* name) const {
    return json::parse(readWhole(folder / name / "summary.json"));
  }
};

std::size_t count(const json& moments, const char* kind) {
  return static_cast<std::size_t>(std::count_if(moments.begin(), moments.end(),
                                                [&](const json& m) { return m["kind"] == kind; }));
}

}  // namespace

TEST_F(SlamReport, HasAStepAnUpdateAndNothingThatIsNotKnown) {
  ASSERT_EQ(map("out"), 0) << err;
  const json data = page("out");
  EXPECT_EQ(data["title"], "room.log");
  EXPECT_EQ(data["steps"]["time_ms"].size(), summary("out")["filter"]["updates"]);
  for (const json& error : data["steps"]["error_mm"]) EXPECT_TRUE(error.is_null());
  EXPECT_TRUE(summary("out")["ate_rmse_m"].is_null());
}

TEST_F(SlamReport, ALogMayHaveAnyName) {
  log = put("<b>\"it's\"&.log", room_log::text(10));
  ASSERT_EQ(map("out"), 0) << err;
  EXPECT_EQ(page("out")["title"], "<b>\"it's\"&.log");
  EXPECT_EQ(readWhole(folder / "out/report.html").find("<b>"), std::string::npos);
}

TEST_F(SlamReport, MomentsAreThoseOfLoopsJson) {
  log = (ariadne::test::shippedDatasets() / "drives/small.rawlog").string();
  ini = put("loops.ini",
            "[filter]\nparticles = 8\n[grid]\nresolution_m = 0.1\n[loop_closing]\nc1_m = 5\n"
            "c2_m = 12\nleave_after_m = 2\ncooldown_m = 2\n");
  ASSERT_EQ(map("out", {"--truth", log + ".truth.tum"}), 0) << err;
  const json loops = json::parse(readWhole(folder / "out/loops.json"));
  const json moments = page("out")["moments"];
  ASSERT_GE(loops["detected"], 2U);
  EXPECT_EQ(count(moments, "detection"), loops["detected"]);
  EXPECT_EQ(count(moments, "entry"), loops["closed"]);
  EXPECT_EQ(count(moments, "recovery"), loops["recovered"]);
  EXPECT_EQ(moments[0]["step"], loops["closings"][0]["detection"]["update"]);
  // A good run of a simulated drive: not exact, and no worse than its rooms are wide.
  EXPECT_GT(summary("out")["ate_rmse_m"], 0.005);
  EXPECT_LT(summary("out")["ate_rmse_m"], 1.5);
  const json errors = page("out")["steps"]["error_mm"];
  EXPECT_GT(errors[errors.size() / 2], 0);
}

TEST_F(SlamReport, TheRunsOwnPathIsWithoutError) {
  ASSERT_EQ(map("first"), 0) << err;
  // In a frame of its own, which alignment takes away.
  auto truth = ariadne::io::readTum(folder / "first/trajectory.tum");
  for (auto& p : truth) p.pose = {-p.pose.y + 7, p.pose.x - 3, p.pose.phi + M_PI / 2};
  ariadne::io::writeTum(folder / "truth.tum", truth);
  ASSERT_EQ(map("second", {"--truth", (folder / "truth.tum").string()}), 0) << err;
  EXPECT_LT(summary("second")["ate_rmse_m"], 1e-5) << "TUM files hold 1e-6 m and more";
  EXPECT_EQ(page("second")["steps"]["error_mm"].back(), 0);
  EXPECT_EQ(readWhole(folder / "first/trajectory.tum"),
            readWhole(folder / "second/trajectory.tum"));
}

TEST_F(SlamReport, ABadTruthIsAnErrorBeforeTheRun) {
  const std::string bad = put("bad.tum", "1 2 3\n");
  EXPECT_EQ(map("out", {"--truth", bad}), 1);
  EXPECT_NE(err.find("bad.tum:1"), std::string::npos) << err;
  EXPECT_EQ(map("out", {"--truth", (folder / "none.tum").string()}), 1);
  EXPECT_NE(err.find("none.tum"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(SlamReport, ATruthOfAnotherTimeIsAWarning) {
  ASSERT_EQ(map("out", {"--truth", put("old.tum", "5 0 0 0 0 0 0 1\n6 1 0 0 0 0 0 1\n")}), 0);
  EXPECT_NE(err.find("old.tum has no pose at any time of the log"), std::string::npos) << err;
  EXPECT_TRUE(summary("out")["ate_rmse_m"].is_null());
}
