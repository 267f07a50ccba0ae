// ariadne-explore as its user sees it, without a process.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "explore_app.h"
#include "slam_app.h"

namespace fs = std::filesystem;

namespace {

using ariadne::io::readWhole;

const fs::path kSource = ariadne::test::shippedDatasets().parent_path();
const std::string kShippedIni = (kSource / "ini" / "explore" / "small.ini").string();

class ExploreApp : public TemporaryFolder {
 protected:
  int run(const std::vector<std::string>& args) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    const int code = ariadne::runExploreApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }
  int explore(const std::string& name, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {kShippedIni, "--out", (folder / name).string()});
    return run(more);
  }
  nlohmann::json json(const std::string& name, const std::string& file) {
    return nlohmann::json::parse(readWhole(folder / name / file));
  }

  std::string out;
  std::string err;
};

}  // namespace

TEST_F(ExploreApp, ExploresTheSmallWorld) {
  ASSERT_EQ(explore("a", {"--particles", "10"}), 0) << err;
  const auto summary = json("a", "summary.json");
  EXPECT_EQ(summary["program"], "ariadne-explore");
  EXPECT_EQ(summary["end_reason"].get<std::string>().rfind("explored", 0), 0U);
  EXPECT_GT(summary["coverage"].get<double>(), 0.99);
  EXPECT_LE(summary["coverage"].get<double>(), 1);
  EXPECT_LT(summary["ate_rmse_m"].get<double>(), 0.5);
  EXPECT_EQ(summary["verdict"], "correct");
  EXPECT_TRUE(summary["correct"].get<bool>());
  // Of 0.25 m, that of a correct map of this world: 1.000 (measured).
  EXPECT_GT(summary["map_score"].get<double>(), 0.98);
  EXPECT_GE(summary["closings"].get<int>(), 1);
  EXPECT_EQ(summary["collisions"], 0);
  EXPECT_GT(summary["distance_m"].get<double>(), 40);
  for (const auto& file : summary["files"])
    EXPECT_GT(fs::file_size(folder / "a" / file.get<std::string>()), 0U) << file;
  for (const char* file : {"drive.rawlog", "truth.tum", "events.json", "report.html", "mapping.ini",
                           "config.ini", "trajectory.tum", "map.yaml"})
    EXPECT_TRUE(fs::exists(folder / "a" / file)) << file;
  EXPECT_LT(fs::file_size(folder / "a" / "report.html"), 10'000'000U);
}

TEST_F(ExploreApp, TheReportListsEveryDecisionAfterWhatLedToIt) {
  ASSERT_EQ(explore("a", {"--particles", "10"}), 0) << err;
  const std::string page = readWhole(folder / "a" / "report.html");
  const std::string mark = R"(id="replay-data">)";
  const std::size_t from = page.find(mark) + mark.size();
  const auto moments =
      nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from))["moments"];
  std::vector<std::string> titles;
  std::size_t decisions = 0;
  for (const auto& m : moments) {
    titles.push_back(m["title"]);
    decisions += m["kind"] == "decision";
  }
  EXPECT_EQ(decisions, json("a", "events.json")["events"].size());
  EXPECT_EQ(titles.back(), "The end");
  const auto place = [&](const char* title) {
    return std::find(titles.begin(), titles.end(), title) - titles.begin();
  };
  EXPECT_LT(place("Loop 0 detected"), place("To the entry of a loop"));
}

TEST_F(ExploreApp, AStrategyWithoutRecoveryIsNotWarnedOfItsLack) {
  ASSERT_EQ(explore("a", {"--strategy", "active_neff", "--particles", "10", "--no-pictures"}), 0);
  EXPECT_GE(json("a", "summary.json")["loops"]["closed"].get<int>(), 1);
  EXPECT_EQ(err.find("recover"), std::string::npos) << err;
}

TEST_F(ExploreApp, EventsCarryTheirNumbers) {
  ASSERT_EQ(explore("a", {"--particles", "10", "--no-pictures"}), 0) << err;
  const auto events = json("a", "events.json")["events"];
  ASSERT_GT(events.size(), 4U);
  EXPECT_EQ(events.back()["kind"], "end");
  bool frontier = false;
  bool loop = false;
  for (const auto& e : events) {
    if (e["kind"] == "frontier") {
      frontier = true;
      EXPECT_FALSE(e["frontiers"].empty());
      EXPECT_EQ(e["goal_m"].size(), 2U);
    }
    if (e["kind"] == "approach") {
      loop = true;
      EXPECT_GE(e["loop"]["places"].get<int>(), 1);
      EXPECT_LT(e["loop"]["dist_m_m"].get<double>(), 6);
      EXPECT_GT(e["loop"]["dist_g_m"].get<double>(), 20);
    }
  }
  EXPECT_TRUE(frontier);
  EXPECT_TRUE(loop);
  for (const auto& f : events.back()["frontiers"]) EXPECT_TRUE(f["left"].is_string());
}

TEST_F(ExploreApp, ItsDriveMapsAgainToTheSameBits) {
  ASSERT_EQ(explore("a", {"--particles", "10", "--no-pictures", "--threads", "2"}), 0) << err;
  std::ostringstream out_stream;
  std::ostringstream err_stream;
  const int code = ariadne::runSlamApp(
      {(folder / "a" / "mapping.ini").string(), "--threads", "1", "--out", (folder / "b").string()},
      out_stream, err_stream);
  ASSERT_EQ(code, 0) << err_stream.str();
  for (const char* file : {"steps.csv", "trajectory.tum", "odometry.tum", "map.gridmap.gz"})
    EXPECT_EQ(readWhole(folder / "a" / file), readWhole(folder / "b" / file)) << file;
}

TEST_F(ExploreApp, TruthIsWhereTheRobotStarted) {
  ASSERT_EQ(
      explore("a", {"--start", "1.5,0.5,90", "--no-pictures", "--set", "explore.max_distance_m=5"}),
      0)
      << err;
  const auto truth = ariadne::io::readTum(folder / "a" / "truth.tum");
  EXPECT_NEAR(truth.front().pose.x, 1.5, 1e-6);
  EXPECT_NEAR(truth.front().pose.y, 0.5, 1e-6);
  EXPECT_NEAR(truth.front().pose.phi, M_PI / 2, 1e-6);
  EXPECT_EQ(json("a", "summary.json")["end_reason"], "max_distance_m is driven");
}

TEST_F(ExploreApp, AMapWhoseWallsAreOffIsBentThoughItsLoopsAreClosed) {
  // Half a cell: as if the walls were off by more than they may be.
  ASSERT_EQ(
      explore("a", {"--particles", "10", "--no-pictures", "--set", "map_score.tolerance_m=0.05"}),
      0)
      << err;
  const auto summary = json("a", "summary.json");
  EXPECT_LT(summary["map_score"].get<double>(), 0.93);
  EXPECT_EQ(summary["verdict"], "bent");
  EXPECT_FALSE(summary["correct"].get<bool>());
  EXPECT_TRUE(summary["closures_correct"].get<bool>());
  EXPECT_NE(out.find("bent: "), std::string::npos) << out;
}

TEST_F(ExploreApp, ADriveWithoutALoopIsNotCalledCorrect) {
  ASSERT_EQ(explore("a", {"--no-pictures", "--set", "explore.max_distance_m=5"}), 0) << err;
  const auto summary = json("a", "summary.json");
  EXPECT_EQ(summary["verdict"], "no_loop");
  EXPECT_EQ(summary["true_closures"], 0);
  for (const char* none :
       {"correct", "closures_correct", "worst_closure_error_m", "worst_closure_error_deg"})
    EXPECT_TRUE(summary[none].is_null()) << none;
  EXPECT_NE(out.find("no true loop to judge it by"), std::string::npos) << out;
}

TEST_F(ExploreApp, WithoutAStartOneIsDrawnFromTheSeed) {
  const std::string world = (folder / "free.world").string();
  ariadne::io::writeWhole(world, "room 0 0 8 6\nstart 1 1 0\n");
  ASSERT_EQ(explore("a", {"--world", world, "--no-pictures", "--set", "explore.max_distance_m=2"}),
            0)
      << err;
  // As a ROS map the world has no start.
  const auto start = [&](const std::string& name, const std::string& seed) {
    EXPECT_EQ(explore(name, {"--world", (folder / "a" / "map.yaml").string(), "--seed", seed,
                             "--no-pictures", "--set", "explore.max_distance_m=2"}),
              0)
        << err;
    return ariadne::io::readTum(folder / name / "truth.tum").front().pose;
  };
  const auto first = start("b", "1");
  EXPECT_EQ(start("c", "1").x, first.x);
  EXPECT_NE(start("d", "2").x, first.x);
}

TEST_F(ExploreApp, ErrorsSayWhatWouldBeRight) {
  EXPECT_EQ(run({}), 2);
  EXPECT_NE(err.find("ini/explore/nested.ini"), std::string::npos) << err;
  EXPECT_EQ(run({(folder / "none.ini").string()}), 1);
  EXPECT_NE(err.find("none.ini"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--strategy", "activ"}), 2);
  EXPECT_NE(err.find("active_neff_recovery"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--start", "1,2"}), 2);
  EXPECT_NE(err.find("x,y,degrees"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--start", "1000,2,0"}), 1);
  EXPECT_NE(err.find("(1000.00, 2.00)"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--world", (folder / "none.world").string()}), 1);
  EXPECT_NE(err.find("none.world"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--set", "explore.sped=1"}), 2);
  EXPECT_NE(err.find("speed_m_s"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(folder / "x"));
}

TEST_F(ExploreApp, ARandomWorldIsDrawnFromTheSeed) {
  const std::vector<std::string> short_drive{"--no-pictures", "--set", "explore.max_distance_m=2",
                                             "--random", "corridors"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), short_drive.begin(), short_drive.end());
    return more;
  };
  ASSERT_EQ(explore("a", with({"--seed", "3"})), 0) << err;
  ASSERT_EQ(explore("b", with({"--seed", "4"})), 0) << err;
  const auto start = [&](const char* name) {
    return ariadne::io::readTum(folder / name / "truth.tum").front().pose;
  };
  EXPECT_NE(start("a").x, start("b").x);
  EXPECT_EQ(explore("x", with({"--world", "a.world"})), 2);
  EXPECT_EQ(explore("x", {"--random", "castle"}), 2);
  EXPECT_NE(err.find("corridors"), std::string::npos) << err;
  EXPECT_EQ(explore("x", {"--set", "world.random=office"}), 2);
  EXPECT_NE(err.find("--set world.file="), std::string::npos) << err;
}

TEST_F(ExploreApp, AResultIsNotOverwrittenUnasked) {
  ASSERT_EQ(explore("a", {"--no-pictures", "--set", "explore.max_distance_m=2"}), 0) << err;
  EXPECT_EQ(explore("a", {"--no-pictures", "--set", "explore.max_distance_m=2"}), 2);
  EXPECT_EQ(explore("a", {"--no-pictures", "--overwrite", "--set", "explore.max_distance_m=2"}), 0);
}

TEST_F(ExploreApp, ItsConfigExploresTheSameAgain) {
  ASSERT_EQ(explore("a", {"--no-pictures", "--strategy", "active_neff", "--set",
                          "explore.max_distance_m=30"}),
            0)
      << err;
  ASSERT_EQ(run({(folder / "a" / "config.ini").string(), "--out", (folder / "b").string()}), 0)
      << err;
  EXPECT_EQ(readWhole(folder / "a" / "truth.tum"), readWhole(folder / "b" / "truth.tum"));
  EXPECT_EQ(readWhole(folder / "a" / "events.json"), readWhole(folder / "b" / "events.json"));
}

TEST_F(ExploreApp, ARobotThatBelievesToBeThinnerIsWarnedOf) {
  ASSERT_EQ(explore("a", {"--no-pictures", "--set", "explore.max_distance_m=2", "--set",
                          "explore.robot_radius_m=0.1"}),
            0);
  EXPECT_NE(err.find("it will touch walls"), std::string::npos) << err;
}

TEST_F(ExploreApp, ShippedInisAndTheParametersPageAreUpToDate) {
  std::size_t found = 0;
  for (const auto& file : fs::directory_iterator(kSource / "ini" / "explore")) {
    EXPECT_EQ(run({file.path().string(), "--print-config"}), 0) << err;
    EXPECT_EQ(err, "") << file.path();
    ++found;
  }
  EXPECT_GE(found, 8U);
  ASSERT_EQ(run({"--print-parameters"}), 0);
  EXPECT_EQ(readWhole(kSource / "doc/reference/parameters-explore.md"), out)
      << "renew it with scripts/renew-parameters";
}
