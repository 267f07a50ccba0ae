// What ariadne-slam tells about loops, on the shipped drive through a small world: a ring with a
// smaller one beside it. c1 and c2 are made to fit its 40 m; the log ends within the outer ring.
#include <mrpt/img/CImage.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "../shipped_datasets.h"
#include "slam_app_fixture.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;
using nlohmann::json;

namespace {

class SlamLoops : public SlamApp {
 protected:
  int drive(const std::vector<std::string>& settings = {}) {
    log = (ariadne::test::shippedDatasets() / "drives/small.rawlog").string();
    ini = put("loops.ini",
              "[filter]\nparticles = 8\n[grid]\nresolution_m = 0.1\n[loop_closing]\nc1_m = 5\n"
              "c2_m = 12\nleave_after_m = 2\ncooldown_m = 2\n");
    std::vector<std::string> arguments;
    for (const std::string& s : settings) arguments.insert(arguments.end(), {"--set", s});
    return map("out", arguments);
  }
  std::string written(const char* name) const { return readWhole(folder / "out" / name); }

  /// Column of every update.
  std::vector<std::string> column(const std::string& name) const {
    std::istringstream csv(written("steps.csv"));
    std::string line;
    std::getline(csv, line);
    const auto split = [](const std::string& text) {
      std::vector<std::string> cells(1);
      for (const char c : text) {
        if (c == ',')
          cells.emplace_back();
        else
          cells.back() += c;
      }
      return cells;
    };
    const auto names = split(line);
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    std::vector<std::string> values;
    while (std::getline(csv, line)) values.push_back(split(line).at(static_cast<std::size_t>(at)));
    return values;
  }
};

}  // namespace

TEST_F(SlamLoops, LoopsAgreeWithTheSteps) {
  ASSERT_EQ(drive(), 0) << err;
  const json loops = json::parse(written("loops.json"));
  const auto state = column("loop_state");
  const auto opportunities = column("opportunities");
  const auto dist_m = column("dist_m_m");
  const auto dist_g = column("dist_g_m");
  const auto time = column("time_s");
  ASSERT_GE(loops["closings"].size(), 2U);
  for (const json& c : loops["closings"]) {
    const json& detection = c["detection"];
    const std::size_t at = detection["update"];
    EXPECT_EQ(detection["time_s"], std::stod(time[at]));
    EXPECT_EQ(detection["opportunities"], std::stoul(opportunities[at]));
    EXPECT_EQ(detection["dist_m_m"], std::stod(dist_m[at]));
    EXPECT_EQ(detection["dist_g_m"], std::stod(dist_g[at]));
    EXPECT_LT(detection["dist_m_m"], 5);
    EXPECT_GT(detection["dist_g_m"], 12);
    EXPECT_LT(c["te"]["update"], at);
    EXPECT_NE(c["entry"]["why"].get<std::string>().find("dist_m < c1 = 5 m"), std::string::npos);
    if (!c["entered"].is_null()) {
      EXPECT_EQ(state[c["entered"]["update"]], "closing");
    }
    EXPECT_EQ(c["recovery"].is_null(), !c["note"].is_null()) << c;
  }
  for (std::size_t i = 0; i < state.size(); ++i) {
    EXPECT_EQ(opportunities[i] == "0", dist_m[i].empty()) << i;
    EXPECT_EQ(dist_m[i].empty(), dist_g[i].empty()) << i;
  }
}

TEST_F(SlamLoops, SavedAndRecoveredSetsAreTold) {
  ASSERT_EQ(drive(), 0) << err;
  const json loops = json::parse(written("loops.json"));
  std::size_t recoveries = 0;
  for (const json& c : loops["closings"]) {
    const json& saved = c["saved"];
    EXPECT_EQ(saved["entries"], 8);
    EXPECT_LE(saved["distinct_ancestors"], saved["existed_at_te"]);
    EXPECT_DOUBLE_EQ(saved["survivors_fraction"], saved["distinct_ancestors"].get<double>() /
                                                      saved["existed_at_te"].get<double>());
    EXPECT_GE(saved["lost_mass"], 0);
    EXPECT_LE(saved["lost_mass"], 1);
    EXPECT_GT(saved["memory_mb"], 0);
    if (c["recovery"].is_null()) continue;
    ++recoveries;
    EXPECT_EQ(c["recovery"]["update"], c["end"]["update"]);
    EXPECT_EQ(c["recovery"]["distinct_ancestors_after"], saved["distinct_ancestors"]);
    EXPECT_GE(c["recovery"]["distinct_ancestors_after"],
              c["recovery"]["distinct_ancestors_before"]);
    EXPECT_GE(c["recovery"]["distinct_ways_drawn"], 1);
  }
  EXPECT_GE(recoveries, 1U);
  EXPECT_EQ(loops["recovered"], recoveries);
  for (const char* name : {"distinct_ancestors", "survivors_fraction", "kl_nats", "lost_mass"})
    EXPECT_TRUE(loops["definitions"].contains(name)) << name;
}

TEST_F(SlamLoops, CountsAndNotesAreTheSameEverywhere) {
  ASSERT_EQ(drive(), 0) << err;
  const json loops = json::parse(written("loops.json"));
  const json summary = json::parse(written("summary.json"));
  for (const char* count : {"detected", "closed", "recovered"})
    EXPECT_EQ(summary["loops"][count], loops[count]) << count;
  EXPECT_EQ(loops["detected"], loops["closings"].size());
  EXPECT_GT(summary["costs"]["wall_s"]["loops"], 0);
  EXPECT_NE(out.find(fmt::format("Loops: {} detected, {} closed, {} followed by a recovery",
                                 loops["detected"].get<int>(), loops["closed"].get<int>(),
                                 loops["recovered"].get<int>())),
            std::string::npos)
      << out;
  // A log that ends within a loop is no fault: it is told where the loops stand.
  const std::string note = "still open at the end of the log: nothing was recovered";
  EXPECT_NE(loops["closings"].dump().find(note), std::string::npos) << loops["closings"];
  EXPECT_EQ(err.find(note), std::string::npos) << err;
  EXPECT_EQ(summary["warnings"].dump().find(note), std::string::npos);
}

// Orange is the colour of the first recovery. Its solid curve runs over the 154 of 216 updates
// before it: 640 of 900 pixels, in rows blended with up to half white.
TEST_F(SlamLoops, CoalescenceShowsTheRecovery) {
  const auto orange = [&](const std::vector<std::string>& settings) {
    EXPECT_EQ(drive(settings), 0) << err;
    const auto image = mrpt::img::CImage::LoadFromFile((folder / "out/coalescence.png").string());
    fs::remove_all(folder / "out");
    std::size_t n = 0;
    for (unsigned y = 0; y < image.getHeight(); ++y)
      for (unsigned x = 0; x < image.getWidth(); ++x)
        n += *image(x, y, 2) > *image(x, y, 1) + 50 && *image(x, y, 1) > *image(x, y, 0) + 40;
    return n;
  };
  EXPECT_EQ(orange({"recovery.enabled=false"}), 0U);
  EXPECT_GT(orange({}), 640U);
}

TEST_F(SlamLoops, WithoutGnuplotOneChartIsLeftOut) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.c_str(), 1);
  const int code = drive({});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(code, 0) << err;
  EXPECT_NE(out.find("left out: charts are drawn by gnuplot"), std::string::npos) << out;
  EXPECT_FALSE(fs::exists(folder / "out" / "coalescence.png"));
  EXPECT_EQ(written("summary.json").find("coalescence.png"), std::string::npos);
}

TEST_F(SlamLoops, WithoutRecoveryClosingsAreStillTold) {
  ASSERT_EQ(drive({"recovery.enabled=false"}), 0) << err;
  const json loops = json::parse(written("loops.json"));
  EXPECT_GE(loops["closed"], 1);
  EXPECT_EQ(loops["recovered"], 0);
  EXPECT_NE(loops["closings"].dump().find("recovery is off"), std::string::npos);
  EXPECT_EQ(err.find("recovery is off"), std::string::npos) << err;
}

TEST_F(SlamLoops, ASavedSetOverTheBudgetIsDroppedAndSaid) {
  ASSERT_EQ(drive({"recovery.memory_budget_mb=1", "grid.resolution_m=0.02", "filter.particles=16",
                   "update.checkpoint_updates=20"}),
            0)
      << err;
  const json loops = json::parse(written("loops.json"));
  EXPECT_EQ(loops["recovered"], 0);
  const std::string said =
      "the saved set was dropped, so nothing was recovered: saved sets took more than "
      "recovery.memory_budget_mb = 1";
  EXPECT_NE(loops["closings"][0]["note"].dump().find(said), std::string::npos) << loops;
  EXPECT_NE(err.find("closing 0: " + said), std::string::npos) << err;
}

TEST_F(SlamLoops, WhereLoopsAreNotLookedForThereAreNoFilesOfThem) {
  ASSERT_EQ(drive({"loop_closing.enabled=false"}), 0) << err;
  for (const char* name : {"loops.json", "topology.png", "coalescence.png"}) {
    EXPECT_FALSE(fs::exists(folder / "out" / name)) << name;
    EXPECT_EQ(out.find(name), std::string::npos) << out;
  }
  EXPECT_EQ(out.find("Loops:"), std::string::npos) << out;
  for (const std::string& state : column("loop_state")) ASSERT_EQ(state, "exploring");
}
