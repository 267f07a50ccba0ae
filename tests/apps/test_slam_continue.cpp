// ariadne-slam --continue: the map of a run is gone on with.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../shipped_datasets.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/simplemap_file.h"
#include "ariadne/io/tum.h"
#include "slam_app_fixture.h"

using namespace ariadne;

/// A shipped drive through a simulated building in two logs: until its 450th scan, and from its
/// 250th on.
class SlamContinue : public SlamApp {
 protected:
  void SetUp() override {
    SlamApp::SetUp();
    ini = put("few.ini", "[filter]\nparticles = 6\n[run]\npictures = false\n");
    first = part("first.rawlog", 0, 450);
    second = part("second.rawlog", 250, 100000);
  }
  std::string part(const std::string& name, std::size_t from, std::size_t to) {
    const auto all = io::openDataset(test::shippedDatasets() / "drives/small.rawlog");
    std::size_t k = 0;
    io::writeObservationRawlog(folder / name, [&]() -> std::optional<models::SensorStep> {
      auto step = all->next();
      for (; step && k < from; ++k) step = all->next();
      if (k++ >= to) return std::nullopt;
      return step;
    });
    return (folder / name).string();
  }
  std::string at(const std::string& name) const { return (folder / name).string(); }
  nlohmann::json summaryOf(const std::string& run_name) const {
    return nlohmann::json::parse(io::readWhole(folder / run_name / "summary.json"));
  }

  std::string first, second;
};

TEST_F(SlamContinue, TheStartIsFoundAndTheMapHasBoth) {
  ASSERT_EQ(run({ini, first, "--out", at("a")}), 0) << err;
  ASSERT_EQ(run({"--continue", at("a"), second, "--out", at("b")}), 0) << err;
  EXPECT_NE(err.find("Goes on in"), std::string::npos) << err;
  const auto before = io::readTum(at("a/trajectory.tum"));
  const auto after = io::readTum(at("b/trajectory.tum"));
  ASSERT_EQ(before[250].time_s, after[0].time_s);
  // Both are matched to one map of 5 cm cells.
  EXPECT_NEAR(after[0].pose.x, before[250].pose.x, 0.1);
  EXPECT_NEAR(after[0].pose.y, before[250].pose.y, 0.1);
  EXPECT_NEAR(std::remainder(after[0].pose.phi - before[250].pose.phi, 2 * M_PI), 0, 0.03);
  EXPECT_NEAR(after[199].pose.x, before[449].pose.x, 0.15);
  EXPECT_NEAR(after[199].pose.y, before[449].pose.y, 0.15);

  const auto told = summaryOf("b");
  EXPECT_EQ(told["continued"]["map"], at("a/map.simplemap"));
  EXPECT_TRUE(told["continued"]["searched"]);
  EXPECT_TRUE(summaryOf("a")["continued"].is_null());
  EXPECT_EQ(told["parameters"]["filter"]["particles"], 6);  // of the run it goes on from
  const auto scans = [&](const char* of) {
    return io::readSimplemap(folder / of / "map.simplemap").size();
  };
  EXPECT_EQ(scans("b"), scans("a") + told["filter"]["updates"].get<std::size_t>());

  // What is written maps the same again.
  ASSERT_EQ(run({at("b/config.ini"), "--out", at("again")}), 0) << err;
  EXPECT_EQ(io::readWhole(at("b/trajectory.tum")), io::readWhole(at("again/trajectory.tum")));
}

TEST_F(SlamContinue, AGivenStartIsTakenAndAWrongOneTold) {
  ASSERT_EQ(run({ini, first, "--out", at("a")}), 0) << err;
  const auto pose = io::readTum(at("a/trajectory.tum"))[250].pose;
  const auto start = [&](double turn_deg) {
    return fmt::format("{:.1f},{:.1f},{:.0f}", pose.x, pose.y, pose.phi * 180 / M_PI + turn_deg);
  };
  const std::string map_file = at("a/map.simplemap");
  ASSERT_EQ(run({ini, second, "--continue", map_file, "--start", start(5), "--out", at("b")}), 0)
      << err;
  EXPECT_FALSE(summaryOf("b")["continued"]["searched"]);
  EXPECT_EQ(run({ini, second, "--continue", map_file, "--start", start(90), "--out", at("c")}), 1);
  EXPECT_NE(err.find("correct --start"), std::string::npos) << err;
  EXPECT_FALSE(std::filesystem::exists(at("c")));
}

TEST_F(SlamContinue, WhatIsWrongIsSaid) {
  EXPECT_EQ(run({ini, second, "--start", "1,2,3"}), 2);
  EXPECT_NE(err.find("--continue"), std::string::npos) << err;
  EXPECT_EQ(run({"--continue", at("a")}), 2);
  EXPECT_NE(err.find("which log"), std::string::npos) << err;
  EXPECT_EQ(run({ini, second, "--continue", at("nowhere")}), 1);
  EXPECT_NE(err.find("there is no"), std::string::npos) << err;
  EXPECT_EQ(run({ini, second, "--continue", folder.string()}), 1);
  EXPECT_NE(err.find("map.simplemap"), std::string::npos) << err;
  EXPECT_EQ(run({ini, second, "--continue", second}), 1);
  EXPECT_NE(err.find("no simple map"), std::string::npos) << err;
  ASSERT_EQ(run({ini, first, "--out", at("a")}), 0) << err;
  for (const char* wrong : {"1,2", "1,2,north", "1,2,3,4", "nan,0,0"}) {
    EXPECT_EQ(run({ini, second, "--continue", at("a"), "--start", wrong}), 2) << wrong;
    EXPECT_NE(err.find("3.5,-2,90"), std::string::npos) << err;
  }
}
