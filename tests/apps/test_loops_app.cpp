#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "../io/temporary_folder.h"
#include "ariadne/io/whole_file.h"
#include "loops_app.h"

namespace fs = std::filesystem;

namespace {

std::string source() { return std::getenv("ARIADNE_SOURCE_DIR"); }
std::string smallIni() { return source() + "/ini/paper/drives/small.ini"; }

class LoopsApp : public TemporaryFolder {
 protected:
  int run(const std::vector<std::string>& args) {
    std::ostringstream to_out;
    std::ostringstream to_err;
    const int code = ariadne::runLoopsApp(args, to_out, to_err);
    out = to_out.str();
    err = to_err.str();
    return code;
  }
  std::string at(const char* name) const { return (folder / name).string(); }
  nlohmann::json summary(const char* name) const {
    return nlohmann::json::parse(ariadne::io::readWhole(folder / name / "summary.json"));
  }
  bool says(const std::string& text) const { return (out + err).find(text) != std::string::npos; }
  std::string out, err;
};

}  // namespace

TEST_F(LoopsApp, ARunIsASummaryOfBothArms) {
  const std::vector<std::string> args{
      smallIni(), "--laps", "1", "--seed", "2", "--set", "filter.particles=4", "--out", at("a")};
  ASSERT_EQ(run(args), 0) << err;
  EXPECT_TRUE(says("small, 1 laps, seed 2: error across the loops: recovery ")) << out;
  const auto json = summary("a");
  EXPECT_EQ(json.at("drive"), "small");
  EXPECT_EQ(json.at("laps"), 1);
  EXPECT_EQ(json.at("seed"), 2);
  for (const char* figure : {"standard_chosen", "recovered_ate_m", "closings", "survivors"})
    EXPECT_TRUE(json.contains(figure)) << figure;
  EXPECT_EQ(run(args), 2) << "the folder holds something";
  EXPECT_EQ(summary("a"), json);
}

TEST_F(LoopsApp, TheOracleIsASummaryOfThreeArms) {
  ASSERT_EQ(run({smallIni(), "--oracle", "--laps", "1", "--seed", "3", "--set",
                 "filter.particles=5", "--out", at("o")}),
            0)
      << err;
  EXPECT_TRUE(says("KL from the oracle's set: recovery ")) << out;
  const auto json = summary("o");
  for (const char* figure : {"oracle_exists", "oracle_chosen", "standard_kl_nats"})
    EXPECT_TRUE(json.contains(figure)) << figure;
  EXPECT_FALSE(json.contains("oracle_kl_nats"));
}

TEST_F(LoopsApp, MapsALogWhosePosesAreTrue) {
  const std::string ini = at("log.ini");
  ariadne::io::writeWhole(ini, "[experiment]\nlog = " + source() +
                                   "/datasets/drives/small.rawlog\n[log_noise]\nrot_trans = "
                                   "0.005\n[filter]\nparticles = 3\n[grid]\nresolution_m = 0.1\n");
  ASSERT_EQ(run({ini, "--seed", "2", "--out", at("a")}), 0) << err;
  EXPECT_EQ(summary("a").at("drive"), "small");
  EXPECT_EQ(run({ini, "--laps", "2", "--out", at("b")}), 2);
  ariadne::io::writeWhole(ini, std::string_view("[experiment]\nlog = none.log\n"));
  EXPECT_EQ(run({ini, "--out", at("c")}), 1);
  EXPECT_FALSE(fs::exists(at("b"))) << "nothing is left of what failed before it began";
  EXPECT_FALSE(fs::exists(at("c")));
}

TEST_F(LoopsApp, SaysWhatIsWrong) {
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({smallIni(), "--set", "loop_closing.c1_m=9", "--out", at("x")}), 2)
      << "not less than c2";
  EXPECT_EQ(run({smallIni(), "--set", "filter.particels=9", "--out", at("y")}), 2);
  EXPECT_TRUE(says("particles")) << err;
  EXPECT_EQ(run({"/none.ini"}), 1);
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_TRUE(says("ariadne-experiment run ini/paper/nested_loop.ini"));
}

/// Every drive that is shipped has no unknown key and can be driven; the mapping is what then
/// fails, at once.
TEST_F(LoopsApp, ShippedDrivesRun) {
  for (const char* name : {"nested", "nested_no_inner", "nested2", "nested2_no_inner", "small"}) {
    const std::string ini = source() + "/ini/paper/drives/" + name + ".ini";
    EXPECT_EQ(run({ini, "--set", "loop_closing.c1_m=999", "--out", at(name)}), 2) << err;
    EXPECT_TRUE(says("c1_m = 999 is not less")) << err;
  }
}
