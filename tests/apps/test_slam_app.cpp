#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "ariadne/io/tum.h"
#include "slam_app_fixture.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;

const std::vector<std::string> kFiles = {
    "trajectory.tum", "odometry.tum", "steps.csv",      "config.ini",    "overview.png",
    "report.html",    "map.png",      "loops.json",     "topology.png",  "coalescence.png",
    "map.pgm",        "map.yaml",     "map.gridmap.gz", "map.simplemap", "summary.json"};

std::size_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST_F(SlamApp, WritesAllFilesAndSaysWhatTheyAreFor) {
  ASSERT_EQ(map("out"), 0) << err;
  EXPECT_EQ(filesIn(folder / "out"), kFiles.size());
  for (const std::string& name : kFiles) {
    EXPECT_GT(fs::file_size(folder / "out" / name), 0U) << name;
    EXPECT_NE(out.find(name), std::string::npos) << out;
  }
  EXPECT_EQ(ariadne::io::readTum(folder / "out/trajectory.tum").size(), 40U);
  EXPECT_EQ(ariadne::io::readTum(folder / "out/odometry.tum").size(), 40U);
  EXPECT_NE(readWhole(folder / "out/trajectory.tum").find("along the odometry"), std::string::npos);
}

TEST_F(SlamApp, SummaryAgreesWithTheOtherFiles) {
  ASSERT_EQ(map("out", {"--seed", "7", "--threads", "1"}), 0) << err;
  const auto json = nlohmann::json::parse(readWhole(folder / "out/summary.json"));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["threads"], 1);
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["dataset"]["scans"], 40);
  EXPECT_NEAR(json["dataset"]["odometry_length_m"], 3.9, 0.05);
  EXPECT_NEAR(json["path_length_m"], 3.9, 0.5);
  EXPECT_NEAR(json["dataset"]["duration_s"], 7.8, 1e-6);
  EXPECT_EQ(json["parameters"]["grid"]["resolution_m"], 0.1);
  EXPECT_GT(json["costs"]["cpu_s"], 0);
  EXPECT_GT(json["costs"]["peak_memory_mb"], 1);
  EXPECT_EQ(json["files"].get<std::vector<std::string>>().size(), kFiles.size());
  const std::size_t updates = json["filter"]["updates"];
  EXPECT_GT(updates, 5U);
  EXPECT_EQ(lines(readWhole(folder / "out/steps.csv")), updates + 1);
  EXPECT_LE(json["filter"]["neff_min"], json["filter"]["neff_mean"]);
}

TEST_F(SlamApp, SaysWhatItTookForNoReturnAndWhatWasTooNear) {
  std::string text, word;
  std::istringstream words(room_log::text(40));
  std::getline(words, text);  // the comment
  for (int i = 0; words >> word; ++i) {
    const bool range = word.size() == 5 && word[1] == '.' && word.find('-') == word.npos;
    if (word == "FLASER") text += '\n';
    if (range && word > "5.0") word = "8.183";
    if (range && i % 1000 == 200) word = "0.006";
    text += word + ' ';
  }
  const std::string coded = put("coded.log", text + '\n');
  const auto figures = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {ini, coded, "--no-pictures", "--out", (folder / "o").string()});
    more.emplace_back("--overwrite");
    EXPECT_EQ(run(more), 0) << err;
    return nlohmann::json::parse(readWhole(folder / "o/summary.json"))["dataset"];
  };
  const auto told = figures({});
  EXPECT_NEAR(told["no_return_from_m"].get<double>(), 8.183, 1e-6) << told;
  EXPECT_GT(told["beams_over_reach"], 500);
  EXPECT_EQ(told["beams_no_return"], told["beams_over_reach"]);
  EXPECT_GT(told["beams_too_near"], 2);
  EXPECT_EQ(told["beams_bad"], told["beams_too_near"]);
  EXPECT_NE(err.find("beams of 8.183 m or more are taken for no return"), std::string::npos) << err;
  EXPECT_NE(err.find("beams are nearer than [dataset] min_range_m"), std::string::npos) << err;
  const auto set = figures({"--set", "dataset.max_range_m=20", "--set", "dataset.min_range_m=0"});
  EXPECT_EQ(set["no_return_from_m"], 20);
  EXPECT_EQ(set["beams_no_return"], 0);
  EXPECT_EQ(set["beams_bad"], 0);
}

TEST_F(SlamApp, SameSeedSameFilesOnAnyNumberOfThreads) {
  ASSERT_EQ(map("one", {"--threads", "1"}), 0) << err;
  ASSERT_EQ(map("two", {"--threads", "2"}), 0) << err;
  ASSERT_EQ(map("other", {"--seed", "2"}), 0) << err;
  for (const char* name : {"trajectory.tum", "steps.csv", "map.gridmap.gz"})
    EXPECT_EQ(readWhole(folder / "one" / name), readWhole(folder / "two" / name)) << name;
  EXPECT_NE(readWhole(folder / "one/steps.csv"), readWhole(folder / "other/steps.csv"));
}

TEST_F(SlamApp, ConfigOfARunMapsTheSameAgain) {
  ASSERT_EQ(map("first", {"--seed", "5"}), 0) << err;
  const std::string config = (folder / "first/config.ini").string();
  ASSERT_EQ(run({config, "--out", (folder / "again").string()}), 0) << err;
  EXPECT_EQ(readWhole(folder / "first/steps.csv"), readWhole(folder / "again/steps.csv"));
}

TEST_F(SlamApp, ALogAloneIsMappedWithTheDefaults) {
  const std::vector<std::string> options = {"--set", "grid.resolution_m=0.1", "--particles", "4"};
  const auto mapInto = [&](const std::string& name, std::vector<std::string> args) {
    args.insert(args.end(), options.begin(), options.end());
    args.insert(args.end(), {"--no-pictures", "--out", (folder / name).string()});
    ASSERT_EQ(run(args), 0) << err;
  };
  mapInto("with", {put("empty.ini", ""), log});
  mapInto("without", {log});
  EXPECT_EQ(readWhole(folder / "with/steps.csv"), readWhole(folder / "without/steps.csv"));
}

TEST_F(SlamApp, FlagsBeatSettingsBeatTheIniBeatsDefaults) {
  EXPECT_NE(resolved({}).find("\nparticles = 4\n"), std::string::npos);
  EXPECT_NE(resolved({"--set", "filter.particles=5"}).find("\nparticles = 5\n"), std::string::npos);
  const std::string all = resolved({"--particles", "6", "--set", "filter.particles=5", "--set",
                                    "filter.beta=0.2", "--set", "filter.beta=0.3"});
  EXPECT_NE(all.find("\nparticles = 6\n"), std::string::npos);
  EXPECT_NE(all.find("\nbeta = 0.3\n"), std::string::npos);
  EXPECT_NE(all.find("\nseed = 1\n"), std::string::npos);
}

TEST_F(SlamApp, RelativeDatasetStartsAtTheIni) {
  ini = put("named.ini", "[dataset]\nfile = room.log\n");
  EXPECT_NE(resolved({}).find("file = " + log + "\n"), std::string::npos) << out;
}

TEST_F(SlamApp, WrongUseIsTwoAndSaysWhatWouldBeRight) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{}, "which log, or which CONFIG?"},
      {{log, ini}, "room.log is a log, not an INI: CONFIG stands before DATASET"},
      {{ini, "--set", "filter.particels=3"}, "the nearest is \"particles\""},
      {{ini, "--set", "nonsense"}, "takes section.key=value"},
      {{ini, "--particles", "many"}, "--particles: [filter] particles = many: is no whole number"},
      {{ini, "--particles", "0"}, "out of bounds: it takes a whole number, 1 to 100000"},
      {{ini, "--seed", "-1"}, "--seed"},
      {{ini, "--theads", "1"}, "--theads"},
      {{ini, log, "more"}, "more"},
      {{ini}, "no dataset"},
      {{ini, log, "--out", "two\nlines"}, "cannot be written to an INI"},
      {{put("bad.ini", "[gird]\n")}, "bad.ini:1: [gird]: no such section; the nearest is [grid]"}};
  for (const auto& [args, expected] : cases) {
    EXPECT_EQ(run(args), 2) << err;
    EXPECT_EQ(err.rfind("ariadne-slam: ", 0), 0U) << err;
    EXPECT_NE(err.find(expected), std::string::npos) << err;
  }
}

TEST_F(SlamApp, WhatCannotBeReadIsOne) {
  EXPECT_EQ(run({(folder / "none.ini").string()}), 1);
  EXPECT_EQ(run({ini, (folder / "none.log").string()}), 1);
  EXPECT_NE(err.find("none.log"), std::string::npos) << err;
}

TEST_F(SlamApp, HelpAndVersionAreFine) {
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_NE(out.find("ariadne-slam ini/slam/sena.ini"), std::string::npos);
  EXPECT_EQ(run({"--version"}), 0);
}

TEST_F(SlamApp, AFolderWithFilesNeedsOverwriteAndKeepsTheOthers) {
  ASSERT_EQ(map("out"), 0) << err;
  put("out/notes.txt", "mine");
  const std::string before = readWhole(folder / "out/steps.csv");
  EXPECT_EQ(map("out", {"--seed", "9"}), 2);
  EXPECT_NE(err.find("--overwrite"), std::string::npos) << err;
  EXPECT_EQ(readWhole(folder / "out/steps.csv"), before);
  EXPECT_EQ(map("out", {"--seed", "9", "--overwrite"}), 0) << err;
  EXPECT_NE(readWhole(folder / "out/steps.csv"), before);
  EXPECT_EQ(readWhole(folder / "out/notes.txt"), "mine");
}

TEST_F(SlamApp, AFolderThatCannotBeWrittenIsToldBeforeMapping) {
  EXPECT_EQ(run({ini, log, "--out", "/proc/ariadne"}), 1);
  EXPECT_NE(err.find("/proc/ariadne"), std::string::npos) << err;
  EXPECT_EQ(out, "");
}

// A file size limit stands for a disk that fills up while the results are written.
TEST_F(SlamApp, AFullDiskIsAnErrorAndNoFileIsHalf) {
  ASSERT_EQ(map("whole"), 0) << err;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{6000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const int code = map("full", {"--set", "run.threads=0"});
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(code, 1);
  EXPECT_NE(err.find("not all files are written"), std::string::npos) << err;
  EXPECT_NE(err.find("map.pgm"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(folder / "full/map.pgm"));
  for (const auto& file : fs::directory_iterator(folder / "full"))
    EXPECT_TRUE(fs::exists(folder / "whole" / file.path().filename())) << file.path();
  EXPECT_EQ(readWhole(folder / "full/steps.csv"), readWhole(folder / "whole/steps.csv"));
}

TEST_F(SlamApp, AMapWithoutABeamIsAnError) {
  log = put("blind.log", room_log::text(5, {[](int) { return true; }}));
  EXPECT_EQ(map("out"), 1);
  EXPECT_NE(err.find("hardly a beam returned"), std::string::npos) << err;
}

TEST_F(SlamApp, QuietPrintsNothingAndPicturesCanBeLeftOut) {
  ASSERT_EQ(map("out", {"--quiet", "--no-pictures"}), 0) << err;
  EXPECT_EQ(out + err, "");
  EXPECT_FALSE(fs::exists(folder / "out/map.png"));
  EXPECT_FALSE(fs::exists(folder / "out/overview.png"));
  EXPECT_FALSE(fs::exists(folder / "out/report.html"));
  EXPECT_EQ(filesIn(folder / "out"), kFiles.size() - 5);
}

TEST_F(SlamApp, TakesStockInis) {
  ini = put("stock.ini",
            "[MappingApplication]\nrawlog_file = nowhere.rawlog\nsampleSize = 3\nBETA = 0.5 // x\n"
            "localizeLinDistance = 0.5\nLOG_FREQUENCY = 1\noccupancyGrid_count = 1\n");
  ASSERT_EQ(map("out"), 0) << err;
  EXPECT_NE(err.find("warning: stock.ini: without meaning here: LOG_FREQUENCY\n"),
            std::string::npos)
      << err;
  EXPECT_NE(readWhole(folder / "out/config.ini").find("\nparticles = 3\n"), std::string::npos);
}
