#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/io/whole_file.h"
#include "compare_app.h"

namespace fs = std::filesystem;
using namespace ariadne;

namespace {
const std::string kLog = (test::shippedDatasets() / "drives" / "small.rawlog").string();
}  // namespace

/// Runs ariadne-slam and ariadne-stock-rbpf, which are built beside the tests.
class CompareApp : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    ini = path("few.ini");
    io::writeWhole(ini,
                   "[filter]\nparticles = 3\nseed = 5\n[grid]\nresolution_m = 0.1\n"
                   "[update]\nupdate_distance_m = 0.7\nupdate_angle_deg = 40\n");
  }
  std::string path(const char* name) const { return (folder / name).string(); }
  int run(std::vector<std::string> args) {
    out.str("");
    err.str("");
    return runCompareApp(args, out, err);
  }
  std::string ini;
  std::ostringstream out, err;
};

TEST_F(CompareApp, SetsBothSideBySide) {
  ASSERT_EQ(run({ini, kLog, "--truth", kLog + ".truth.tum", "--repeats", "2", "--out", path("c"),
                 "--json", path("c.json"), "--require", "cpu_ratio > 0", "--require",
                 "ours_updates>=10"}),
            0)
      << err.str();
  const auto json = nlohmann::json::parse(io::readWhole(path("c.json")));
  const auto& figures = json["figures"];
  // Both decide by the same odometry when to update.
  EXPECT_EQ(figures["updates"]["ours"]["values"], figures["updates"]["stock"]["values"]);
  for (const char* name : {"cpu_s", "wall_s", "memory_mb", "neff_share", "length_m", "ate_m",
                           "ate_heading_deg", "rpe_m", "rpe_heading_deg"}) {
    for (const char* side : {"ours", "stock"}) {
      ASSERT_EQ(figures[name][side]["values"].size(), 2U) << name;
      EXPECT_GT(figures[name][side]["min"], 0) << name << side;
      EXPECT_GE(figures[name][side]["max"], figures[name][side]["median"]) << name << side;
    }
    EXPECT_NE(out.str().find(name), std::string::npos) << name << out.str();
  }
  EXPECT_EQ(figures.count("relations_m"), 0U);
  EXPECT_TRUE(json["requirements"][1]["met"]);
  const std::string page = io::readWhole(folder / "c" / "compare.html");
  std::size_t pictures = 0;
  for (auto at = page.find("data:image/png;base64,iVBOR"); at != page.npos;
       at = page.find("data:image/png;base64,iVBOR", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 2U);
  EXPECT_NE(page.find("<span class=\"term\" title=\"effective number of particles"), page.npos)
      << "no word is explained";
  EXPECT_NE(page.find("<li>met: cpu_ratio &gt; 0 (it is "), page.npos);
  EXPECT_EQ(page.find("{{"), page.npos) << "a part of the template is left empty";
  const std::string stock_ini = io::readWhole(folder / "c" / "stock.ini");
  for (const char* part : {"sampleSize", "localizeLinDistance", "maxDistanceInsertion"})
    EXPECT_NE(stock_ini.find(part), std::string::npos) << part;
}

TEST_F(CompareApp, TellsBeforehandHowLongItTakes) {
  const std::vector<std::string> often{"--set", "update.update_distance_m=0.3"};
  std::vector<std::string> args{ini, kLog, "--repeats", "2", "--out", path("c")};
  args.insert(args.end(), often.begin(), often.end());
  ASSERT_EQ(run(args), 0) << err.str();
  const std::string told = err.str();
  const std::string time = R"(\d+:\d\d)";
  EXPECT_TRUE(
      std::regex_search(told, std::regex("2 runs of ariadne-slam, " + time +
                                         " each; 2 runs of stock MRPT, " + time + " each; " + time +
                                         " in all, as their beginnings show\n"
                                         "run 1 of 2, ariadne-slam: 0 % of all, " +
                                         time + " left\n")))
      << told;
  EXPECT_NE(told.find("run 2 of 2, stock MRPT: "), told.npos) << told;
  args.insert(args.end(), {"--overwrite", "--quiet"});
  ASSERT_EQ(run(args), 0) << err.str();
  EXPECT_EQ(err.str(), "");
}

TEST_F(CompareApp, RefusesToGoOnInAMap) {
  io::writeWhole(folder / "on.ini", "[continue]\nrun = " + path("earlier") + "\n");
  EXPECT_EQ(run({path("on.ini"), kLog, "--out", path("c")}), 2);
  EXPECT_NE(err.str().find("[continue] run = " + path("earlier")), std::string::npos) << err.str();
  EXPECT_NE(err.str().find("--set continue.run="), std::string::npos) << err.str();
  EXPECT_FALSE(fs::exists(folder / "c"));
  EXPECT_EQ(run({path("on.ini"), kLog, "--set", "continue.run=", "--particles", "2", "--repeats",
                 "1", "--out", path("c")}),
            0)
      << err.str();
}

TEST_F(CompareApp, SaysWhichRequirementIsNotMet) {
  const std::vector<std::string> args{ini,     kLog,      "--repeats", "1",
                                      "--out", path("c"), "--require", "updates_ratio<0.5"};
  EXPECT_EQ(run(args), 1);
  EXPECT_NE(out.str().find("NOT MET: updates_ratio<0.5 (it is 1)"), std::string::npos) << out.str();
  EXPECT_EQ(run(args), 2) << "the folder is not empty";
  auto again = args;
  again.back() = "updates_ratio<=1";
  again.emplace_back("--overwrite");
  EXPECT_EQ(run(again), 0) << err.str();
}

TEST_F(CompareApp, TakesRelationsAndAnIniOfRbpfSlam) {
  // The robot never moves a kilometre in two seconds: both are off by about that.
  io::writeWhole(folder / "r.relations", "10 12 1000 0 0 0 0 0\n");
  const std::string stock =
      "/usr/share/mrpt/config_files/rbpf-slam/gridmapping_optimal_sampling.ini";
  ASSERT_EQ(run({stock, kLog, "--particles", "2", "--repeats", "1", "--out", path("c"),
                 "--relations", path("r.relations"), "--require", "ours_relations_m>990",
                 "--require", "stock_relations_m>990", "--quiet"}),
            0)
      << err.str() << out.str();
  EXPECT_EQ(out.str().find("compare.html"), std::string::npos);
}

TEST_F(CompareApp, TellsWhatAFailedRunSaid) {
  EXPECT_EQ(run({ini, kLog, "--stock-program", "/bin/false", "--out", path("a")}), 1);
  EXPECT_NE(err.str().find("/bin/false failed with exit code 1"), std::string::npos) << err.str();
  io::writeWhole(folder / "bad.rawlog", "FLASER nothing of use");
  EXPECT_EQ(run({ini, path("bad.rawlog"), "--out", path("b")}), 1);
  EXPECT_NE(err.str().find("bad.rawlog"), std::string::npos) << err.str();
}

TEST_F(CompareApp, WrongUseIsToldBeforeTheRuns) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({ini}), 2);
  EXPECT_EQ(run({path("none.ini"), kLog}), 1);
  EXPECT_EQ(run({ini, path("none.rawlog")}), 1);
  const std::vector<std::string> good{ini, kLog, "--out", path("c")};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), good.begin(), good.end());
    return run(more);
  };
  EXPECT_EQ(with({"--require", "cpu<3"}), 2);
  EXPECT_NE(err.str().find("cpu_ratio"), std::string::npos) << err.str();
  EXPECT_EQ(with({"--require", "ate_ratio<1"}), 2);
  EXPECT_NE(err.str().find("--truth"), std::string::npos) << err.str();
  EXPECT_EQ(with({"--require", "cpu_ratio<x"}), 2);
  EXPECT_EQ(with({"--require", "cpu_ratio=1"}), 2);
  EXPECT_EQ(with({"--repeats", "0"}), 2);
  EXPECT_EQ(with({"--seed", "2147483646"}), 2);  // three repeats
  EXPECT_EQ(with({"--json", "/nowhere/c.json"}), 2);
  EXPECT_EQ(with({"--truth", path("none.tum")}), 1);
  EXPECT_EQ(with({"--slam-program", path("none")}), 2);
  io::writeWhole(folder / "points.ini", "[MappingApplication]\npointsMap_count = 1\n");
  EXPECT_EQ(with({"--stock-ini", path("points.ini")}), 2);
  EXPECT_NE(err.str().find("occupancyGrid_count"), std::string::npos) << err.str();
  EXPECT_FALSE(fs::exists(folder / "c"));
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_NE(out.str().find("cpu_ratio"), std::string::npos);
}
