#include <nlohmann/json.hpp>
#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "eval_app.h"

namespace fs = std::filesystem;
using namespace ariadne;

class EvalApp : public TemporaryFolder {
 protected:
  int run(const std::vector<std::string>& args) {
    out.str("");
    err.str("");
    return runEvalApp(args, out, err);
  }
  std::string path(const char* name) const { return (folder / name).string(); }
  /// An arc of 40 poses; the estimate lies elsewhere and is `error` m off to its side at every
  /// other.
  void writeArc(double error) {
    geometry::Trajectory truth;
    geometry::Trajectory estimate;
    for (int i = 0; i < 40; ++i) {
      const mrpt::math::TPose2D pose(5 * std::cos(0.1 * i), 5 * std::sin(0.1 * i), 0.1 * i);
      truth.push_back({100.0 + i, pose});
      estimate.push_back(
          {100.0 + i,
           geometry::compose({7, 8, 1}, geometry::compose(pose, {i % 2 ? error : -error, 0, 0}))});
    }
    io::writeTum(path("truth.tum"), truth);
    io::writeTum(path("estimate.tum"), estimate);
  }
  std::ostringstream out, err;
};

TEST_F(EvalApp, FindsTheKnownError) {
  writeArc(0.05);
  ASSERT_EQ(run({path("estimate.tum"), path("truth.tum"), "--json"}), 0) << err.str();
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_NEAR(json["truth"]["ate_m"]["rmse"], 0.05, 1e-3);
  EXPECT_EQ(json["truth"]["pairs"], 40);
  EXPECT_NEAR(json["truth"]["ate_heading_deg"]["max"], 0, 0.1);
}

TEST_F(EvalApp, FindsTheErrorAcrossALoop) {
  geometry::Trajectory truth;
  geometry::Trajectory estimate;
  for (int i = 0; i < 160; ++i) {  // twice round; the estimate's second lap is 0.4 m off
    const mrpt::math::TPose2D pose(5 * std::cos(0.1 * i), 5 * std::sin(0.1 * i), 0.1 * i);
    truth.push_back({100.0 + i, pose});
    estimate.push_back({100.0 + i, {pose.x + (i < 63 ? 0 : 0.4), pose.y, pose.phi}});
  }
  io::writeTum(path("truth.tum"), truth);
  io::writeTum(path("estimate.tum"), estimate);
  ASSERT_EQ(run({path("estimate.tum"), path("truth.tum"), "--json"}), 0) << err.str();
  const auto closures = nlohmann::json::parse(out.str())["truth"]["closures"];
  EXPECT_GT(closures["count"], 20);
  EXPECT_EQ(closures["unmatched"], 0);
  EXPECT_NEAR(closures["error_m"]["max"], 0.4, 1e-6);
  EXPECT_NEAR(closures["error_heading_deg"]["max"], 0, 1e-6);
  ASSERT_EQ(run({path("estimate.tum"), path("truth.tum")}), 0) << err.str();
  EXPECT_NE(out.str().find("across loops, position"), std::string::npos) << out.str();
}

TEST_F(EvalApp, TextHasEveryMeasure) {
  writeArc(0.05);
  io::writeWhole(folder / "r.relations", "100 101 0.49 0.025 0 0 0 0.1\n1 2 0 0 0 0 0 0\n");
  ASSERT_EQ(run({path("estimate.tum"), path("truth.tum"), "--relations", path("r.relations")}), 0)
      << err.str();
  for (const char* part : {"ATE, position", "RPE over 1 m", "relations, translation", "RMSE",
                           "40 of 40 true poses", "1 relations are outside"})
    EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
}

TEST_F(EvalApp, PlotsAndKeepsWhatIsThere) {
  writeArc(0.05);
  for (const char* name : {"p.png", "p.svg"}) {
    const std::vector<std::string> args{path("estimate.tum"), path("truth.tum"), "--plot",
                                        path(name)};
    ASSERT_EQ(run(args), 0) << err.str();
    EXPECT_GT(fs::file_size(folder / name), 3000U);
    const auto before = io::readWhole(folder / name);
    EXPECT_EQ(run(args), 1);
    EXPECT_NE(err.str().find("exists"), std::string::npos);
    EXPECT_EQ(io::readWhole(folder / name), before);
    auto again = args;
    again.push_back("-w");
    EXPECT_EQ(run(again), 0) << err.str();
  }
  EXPECT_EQ(run({path("estimate.tum"), path("truth.tum"), "--plot", path("p.pdf")}), 2);
  EXPECT_EQ(run({path("estimate.tum"), path("truth.tum"), "--plot", "/nowhere/p.png"}), 1);
}

TEST_F(EvalApp, SaysWhenNothingMatchesInTime) {
  writeArc(0);
  io::writeTum(folder / "late.tum", {{5000, {}}, {5001, {}}});
  EXPECT_EQ(run({path("estimate.tum"), path("late.tum")}), 1);
  for (const char* part : {"no time in common", "100.00 to 139.00", "5000.00 to 5001.00"})
    EXPECT_NE(err.str().find(part), std::string::npos) << err.str();
  io::writeWhole(folder / "r.relations", "1 2 0 0 0 0 0 0\n");
  EXPECT_EQ(run({path("estimate.tum"), "--relations", path("r.relations")}), 1);
}

TEST_F(EvalApp, WrongUseAndBadFiles) {
  writeArc(0);
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({path("estimate.tum")}), 2);
  EXPECT_EQ(run({path("estimate.tum"), path("truth.tum"), "--delta", "-1"}), 2);
  EXPECT_EQ(run({"--relations", "x", path("estimate.tum"), "--plot", "p.png"}), 2);
  EXPECT_EQ(run({path("none.tum"), path("truth.tum")}), 1);
  EXPECT_NE(err.str().find("none.tum"), std::string::npos);
  io::writeWhole(folder / "bad.tum", "1 2 nan 4 5 6 7 8\n");
  EXPECT_EQ(run({path("bad.tum"), path("truth.tum")}), 1);
  EXPECT_NE(err.str().find("bad.tum:1"), std::string::npos);
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_NE(out.str().find("Examples"), std::string::npos);
}

TEST_F(EvalApp, PlansAnExperiment) {
  ASSERT_EQ(run({"plan", "0.40", "0.93", "--power", "0.9", "--json"}), 0) << err.str();
  const auto fisher = nlohmann::json::parse(out.str());
  EXPECT_EQ(fisher["test"], "Fisher");
  EXPECT_GE(fisher["power"], 0.9);
  ASSERT_EQ(run({"plan", "0.40", "0.93", "--power", "0.9", "--paired", "--json"}), 0) << err.str();
  const auto mcnemar = nlohmann::json::parse(out.str());
  EXPECT_GE(mcnemar["power"], 0.9);
  EXPECT_NEAR(mcnemar["discordant_shares"][0], 0.4 * 0.07, 1e-12);
  ASSERT_EQ(run({"plan", "0.40", "0.93"}), 0) << err.str();
  EXPECT_NE(out.str().find("runs an arm"), std::string::npos);
  EXPECT_EQ(run({"plan"}), 2);
  EXPECT_EQ(run({"plan", "0.4", "1.2"}), 2);
  EXPECT_EQ(run({"plan", "0.4", "0.4"}), 2);
  EXPECT_EQ(run({"plan", "0.4", "0.93", "--only-first", "0.05"}), 2);
  EXPECT_EQ(run({"plan", "0.4", "0.93", "--paired", "--only-first", "0.08"}), 2);
  EXPECT_NE(err.str().find("between 0 and 0.07"), std::string::npos) << err.str();
  EXPECT_EQ(run({"plan", "--help"}), 0);
}

TEST_F(EvalApp, NeffOfALogByItsPasses) {
  io::writeWhole(path("truth.tum"), "0 0 0 0 0 0 0 1\n30 30 0 0 0 0 0 1\n60 0 0 0 0 0 0 1\n");
  const auto steps = [&](const char* name, const char* neff) {
    io::writeWhole(path(name),
                   "step,time_s,neff,resampled,particles\n0,0,30,0,30\n"
                   "1,15,15,1,30\n2,55," +
                       std::string(neff) + ",0,30\n");
    return path(name);
  };
  ASSERT_EQ(run({"neff-log", path("truth.tum"), path("neff.png"), "--plain", steps("a.csv", "15"),
                 steps("b.csv", "15"), "--revisit", steps("c.csv", "30"), steps("d.csv", "30")}),
            0)
      << err.str();
  const std::string said = out.str();
  // ln 2 over 15 m of new ground; the same over 40 m on the way back, or nothing.
  EXPECT_NE(said.find("| never | 15 | plain | -0.46 [-0.46 to -0.46] | 0.67 "), std::string::npos)
      << said;
  EXPECT_NE(said.find("| once | 40 | plain | -0.17 "), std::string::npos) << said;
  EXPECT_NE(said.find("| once | 40 | revisit | 0.00 "), std::string::npos) << said;
  EXPECT_EQ(said.find("twice"), std::string::npos) << "nothing was";
  EXPECT_TRUE(fs::exists(path("neff.png")));
  EXPECT_EQ(run({"neff-log", path("truth.tum"), path("neff.png"), "--plain", "/none.csv",
                 "--revisit", "/none.csv"}),
            1);
  EXPECT_EQ(run({"neff", path("none.ini"), path("x.png")}), 1);
  EXPECT_EQ(run({"neff"}), 2);
}

TEST_F(EvalApp, WeightsOfADriveByItsPasses) {
  const std::string small =
      (ariadne::test::shippedDatasets().parent_path() / "ini/paper/drives/small.ini").string();
  ASSERT_EQ(run({"weights", small, "--last", "2", "--least", "0.05", "--stretch", "5"}), 0)
      << err.str();
  const std::string said = out.str();
  EXPECT_NE(said.find("| never | 2 | "), std::string::npos) << said;
  EXPECT_NE(said.find("| once | 2 | "), std::string::npos) << said;
  ASSERT_EQ(run({"weights", small, "--last", "2", "--least", "0.05", "--stretch", "5"}), 0);
  EXPECT_EQ(out.str(), said);
  EXPECT_EQ(run({"weights", small, "--first", "3", "--last", "2"}), 2);
  EXPECT_EQ(run({"weights", small, "--set", "filter.new_ground_weight=0"}), 2);
  EXPECT_EQ(run({"weights", path("none.ini")}), 1);
  EXPECT_EQ(run({"weights"}), 2);
}
