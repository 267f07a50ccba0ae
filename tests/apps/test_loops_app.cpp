#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ariadne/experiment/run_rows.h"
#include "loops_app.h"

namespace fs = std::filesystem;

namespace {

struct Ran {
  int code;
  std::string out;
  std::string err;
};

Ran run(const std::vector<std::string>& args) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = ariadne::runLoopsApp(args, out, err);
  return {code, out.str(), err.str()};
}

std::string smallIni() {
  return std::string(std::getenv("ARIADNE_SOURCE_DIR")) + "/ini/experiments/small.ini";
}

}  // namespace

TEST(LoopsApp, RunsOnceAndGoesOn) {
  const fs::path rows = fs::temp_directory_path() / ("rows-" + std::to_string(::getpid()) + ".csv");
  const std::vector<std::string> first{
      "run", smallIni(), rows.string(),       "--laps", "1", "--first", "1", "--last",
      "1",   "--set",    "filter.particles=4"};
  ASSERT_EQ(run(first).code, 0);
  EXPECT_EQ(ariadne::experiment::readRows(rows).size(), 1U);
  EXPECT_EQ(run(first).err, "") << "done already";
  const Ran table = run({"table", rows.string()});
  EXPECT_EQ(table.code, 0);
  EXPECT_NE(table.out.find("| small | 1 |"), std::string::npos) << table.out;
  fs::remove(rows);
}

TEST(LoopsApp, TheOracleIsARowOfThreeArms) {
  const fs::path rows =
      fs::temp_directory_path() / ("oracle-" + std::to_string(::getpid()) + ".csv");
  const std::vector<std::string> args{"run",    smallIni(), rows.string(), "--oracle",
                                      "--laps", "1",        "--first",     "3",
                                      "--last", "3",        "--set",       "filter.particles=5"};
  const Ran ran = run(args);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.err.find("KL from the oracle's set: recovery "), std::string::npos) << ran.err;
  std::ifstream in(rows);
  std::string header;
  std::string row;
  std::getline(in, header);
  std::getline(in, row);
  EXPECT_EQ(header.rfind("name,laps,seed,oracle_exists,oracle_chosen,", 0), 0U) << header;
  EXPECT_NE(header.find(",standard_kl_nats"), std::string::npos) << header;
  EXPECT_EQ(row.rfind("small,1,3,", 0), 0U) << row;
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(header.begin(), header.end(), ','));
  EXPECT_EQ(run(args).err, "") << "done already";
  const Ran pairs = run({"run", smallIni(), rows.string(), "--laps", "1"});
  EXPECT_EQ(pairs.code, 1);
  EXPECT_NE(pairs.err.find("rows of another command"), std::string::npos) << pairs.err;
  fs::remove(rows);
}

TEST(LoopsApp, MapsALogWhosePosesAreTrue) {
  const fs::path rows = fs::temp_directory_path() / ("log-" + std::to_string(::getpid()) + ".csv");
  const fs::path ini = fs::temp_directory_path() / ("log-" + std::to_string(::getpid()) + ".ini");
  std::ofstream(ini) << "[experiment]\nlog = " << std::getenv("ARIADNE_SOURCE_DIR")
                     << "/datasets/drives/small.rawlog\n[log_noise]\nrot_trans = 0.005\n"
                     << "[filter]\nparticles = 3\n[grid]\nresolution_m = 0.1\n";
  const Ran ran = run({"run", ini.string(), rows.string(), "--first", "2", "--last", "2"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ariadne::experiment::readRows(rows).at(0).name, "small");
  EXPECT_EQ(run({"run", ini.string(), rows.string(), "--laps", "2"}).code, 2);
  EXPECT_EQ(run({"neff", ini.string(), "x.png"}).code, 2);
  std::ofstream(ini) << "[experiment]\nlog = none.log\n";
  EXPECT_EQ(run({"run", ini.string(), "x.csv"}).code, 1);
  fs::remove(rows);
  fs::remove(ini);
}

TEST(LoopsApp, SaysWhatIsWrong) {
  EXPECT_EQ(run({}).code, 2);
  EXPECT_EQ(run({"run", smallIni(), "x.csv", "--first", "5", "--last", "2"}).code, 2);
  EXPECT_EQ(run({"run", smallIni(), "x.csv", "--set", "loop_closing.c1_m=9"}).code, 2)
      << "not less than c2";
  const Ran typo = run({"run", smallIni(), "x.csv", "--set", "filter.particels=9"});
  EXPECT_EQ(typo.code, 2);
  EXPECT_NE(typo.err.find("particles"), std::string::npos) << typo.err;
  EXPECT_EQ(run({"run", "/none.ini", "x.csv"}).code, 1);
  EXPECT_EQ(run({"table", "/none.csv"}).code, 1);
  EXPECT_FALSE(fs::exists("x.csv"));
}

TEST(LoopsApp, HelpIsFine) {
  const Ran help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_NE(help.out.find("ariadne-loop-experiment table rows.csv"), std::string::npos);
}

/// Every experiment that is shipped has no unknown key and a drive that can be driven; the mapping
/// is what then fails, at once.
TEST(LoopsApp, ShippedExperimentsRun) {
  for (const char* name : {"nested", "nested_no_inner", "nested2", "nested2_no_inner", "small"}) {
    const std::string ini =
        std::string(std::getenv("ARIADNE_SOURCE_DIR")) + "/ini/experiments/" + name + ".ini";
    const Ran ran = run({"run", ini, "x.csv", "--set", "loop_closing.c1_m=999"});
    EXPECT_EQ(ran.code, 2) << ran.err;
    EXPECT_NE(ran.err.find("c1_m = 999 is not less"), std::string::npos) << ran.err;
  }
}

TEST(LoopsApp, NeffOfALogByItsPasses) {
  const fs::path folder =
      fs::temp_directory_path() / ("ariadne-neff-log-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string truth = (folder / "truth.tum").string();
  std::ofstream(truth) << "0 0 0 0 0 0 0 1\n30 30 0 0 0 0 0 1\n60 0 0 0 0 0 0 1\n";
  const auto steps = [&](const char* name, double neff) {
    const std::string file = (folder / name).string();
    std::ofstream(file) << "step,time_s,neff,resampled,particles,\n0,0,30,0,30,\n1,15,15,1,30,\n"
                        << "2,55," << neff << ",0,30,\n";
    return file;
  };
  const std::string png = (folder / "neff.png").string();
  const Ran ran = run({"neff-log", truth, png, "--plain", steps("a.csv", 15), steps("b.csv", 15),
                       "--revisit", steps("c.csv", 30), steps("d.csv", 30)});
  EXPECT_EQ(ran.code, 0) << ran.err;
  // ln 2 over 15 m of new ground; the same over 40 m on the way back, or nothing.
  EXPECT_NE(ran.out.find("| never | 15 | plain | -0.46 [-0.46 to -0.46] | 0.67 "),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("| once | 40 | plain | -0.17 "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("| once | 40 | revisit | 0.00 "), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("twice"), std::string::npos) << "nothing was";
  EXPECT_TRUE(fs::exists(png));
  EXPECT_EQ(run({"neff-log", truth, png, "--plain", "/none.csv", "--revisit", "/none.csv"}).code,
            1);
  fs::remove_all(folder);
}
