#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
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
