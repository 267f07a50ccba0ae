#include <nlohmann/json.hpp>
#include <sstream>

#include "../io/temporary_folder.h"
#include "../io/walled_log.h"
#include "ariadne/io/tum.h"
#include "dataset_app.h"

using namespace sample;  // NOLINT: a test of these samples
namespace fs = std::filesystem;

class DatasetApp : public TemporaryFolder {
 protected:
  int run(const std::vector<std::string>& args) {
    out.str("");
    err.str("");
    return ariadne::runDatasetApp(args, out, err);
  }
  std::string path(const char* name) const { return (folder / name).string(); }
  std::string write(const char* name, const std::string& bytes) const {
    io::writeWhole(folder / name, bytes);
    return path(name);
  }
  std::size_t files() const { return std::distance(fs::directory_iterator(folder), {}); }
  std::ostringstream out, err;
};

TEST_F(DatasetApp, InfoSaysWhatIsInALog) {
  ASSERT_EQ(run({"info", write("a.rawlog", pairsLog(20))}), 0) << err.str();
  for (const char* part :
       {"MRPT rawlog", "20 CSensoryFrame", "20 increments", "19 beams over 180.00 deg",
        "x 0.200 y 0.000 z 0.300", "5.00 Hz", "path: 9.50 m", "can be mapped: yes"})
    EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
  EXPECT_EQ(err.str(), "");
}

TEST_F(DatasetApp, InfoAsJson) {
  ASSERT_EQ(run({"info", write("a.log", carmenLog(20)), "--json"}), 0) << err.str();
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json["format"], "CARMEN log");
  EXPECT_EQ(json["counts"]["steps"], 20);
  EXPECT_EQ(json["lasers"][0]["beams"], (std::vector<int>{181, 181}));
  EXPECT_NEAR(json["path_length_m"].get<double>(), 9.5, 1e-9);
  EXPECT_NEAR(json["duration_s"].get<double>(), 3.8, 1e-6);
  EXPECT_TRUE(json["can_be_mapped"].get<bool>());
}

TEST_F(DatasetApp, InfoSaysWhyALogCannotBeMapped) {
  Rawlog bare;
  for (int i = 0; i < 3; ++i) bare.add(*scan(kBegin_s + i));
  ASSERT_EQ(run({"info", write("a.rawlog", bare.bytes())}), 0) << err.str();
  EXPECT_NE(out.str().find("can be mapped: no: no odometry"), std::string::npos) << out.str();
  ASSERT_EQ(run({"info", write("b.rawlog", Rawlog().add(imu()).bytes())}), 0) << err.str();
  EXPECT_NE(out.str().find("can be mapped: no: no 2D laser"), std::string::npos) << out.str();
}

TEST_F(DatasetApp, InfoAgreesWithTheMapperOnASingleScan) {
  ASSERT_EQ(run({"info", write("a.log", carmenLog(1))}), 0) << err.str();
  EXPECT_NE(out.str().find("can be mapped: yes"), std::string::npos) << out.str();
}

TEST_F(DatasetApp, InfoAsksForAnglesThatNobodySays) {
  const std::string log = write("a.log", flaser(541, "1", "0 0 0", "0 0 0", kBegin_s) +
                                             flaser(541, "1", "0 0 0", "0 0 0", kBegin_s + 1));
  ASSERT_EQ(run({"info", log}), 0) << err.str();
  for (const char* part : {"541 beams over an unknown angle", "can be mapped: no: FLASER lines",
                           "ariadne-dataset's --field-of-view"})
    EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
  EXPECT_EQ(run({"import", log, path("b.rawlog")}), 1);
  ASSERT_EQ(run({"info", log, "--field-of-view", "270"}), 0) << err.str();
  for (const char* part : {"541 beams over 270.00 deg", "can be mapped: yes",
                           "note: FLASER: 541 beams from -135 to 135 degrees, by field_of_view"})
    EXPECT_NE(out.str().find(part), std::string::npos) << part << "\n" << out.str();
  ASSERT_EQ(run({"info", write("c.rawlog", pairsLog(5)), "--field-of-view", "270"}), 0);
  EXPECT_NE(out.str().find("warning: field_of_view_deg is not used"), std::string::npos);
}

TEST_F(DatasetApp, InfoKnowsAllLasersAndWhichIsTilted) {
  Rawlog log;
  for (int i = 0; i < 4; ++i) {
    auto tilted = scan(kBegin_s + i, "tilted");
    tilted->sensorPose = mrpt::poses::CPose3D(0, 0, 1, 0, 0.5, 0);
    log.add(action({0.1, 0, 0})).frame({scan(kBegin_s + i, "flat"), tilted});
  }
  const std::string file = write("a.rawlog", log.bytes());
  ASSERT_EQ(run({"info", file}), 0) << err.str();
  EXPECT_NE(out.str().find("yes, with one of the lasers chosen"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("tilted: not for a map"), std::string::npos);
  ASSERT_EQ(run({"info", file, "--laser", "tilted"}), 0);
  EXPECT_NE(out.str().find("can be mapped: no: no usable scan"), std::string::npos) << out.str();
}

TEST_F(DatasetApp, InfoOfALabelThatIsNotUtf8) {
  Rawlog log;
  log.add(action({})).frame({scan(kBegin_s, "\xff\xfe")});
  ASSERT_EQ(run({"info", write("a.rawlog", log.bytes()), "--json"}), 0) << err.str();
  EXPECT_TRUE(nlohmann::json::accept(out.str())) << out.str();
}

TEST_F(DatasetApp, InfoSaysWhatMeansNoReturnAndWhatIsTooNear) {
  Laser laser;
  laser.reach_m = 8;
  laser.nothing = {8.183F};
  const auto poses = driveAlong({{-9, -4}, {9, -4}, {9, 4}, {-9, 4}});
  const std::string file = write("a.rawlog", walledLog(room(30, 20), poses, laser));
  ASSERT_EQ(run({"info", file}), 0) << err.str();
  EXPECT_NE(out.str().find("beams of 8.183 m or more are taken for no return"), std::string::npos)
      << out.str();
  ASSERT_EQ(run({"info", file, "--json"}), 0) << err.str();
  auto json = nlohmann::json::parse(out.str());
  EXPECT_NEAR(json["no_return"]["from_m"].get<double>(), 8.183, 1e-6);
  EXPECT_EQ(json["no_return"]["codes"][0]["range_m"], 8.183);
  EXPECT_EQ(json["no_return"]["codes"][0]["beams"], json["counts"]["beams_over_reach"]);
  EXPECT_GT(json["counts"]["beams_over_reach"], 1000);
  ASSERT_EQ(run({"info", file, "--json", "--max-range", "60", "--min-range", "7"}), 0) << err.str();
  json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json["counts"]["beams_over_reach"], 0);
  EXPECT_GT(json["counts"]["beams_too_near"], 1000);
  EXPECT_EQ(run({"info", file, "--max-range", "-1"}), 2);
  EXPECT_EQ(run({"info", file, "--min-range", "nan"}), 2);
}

TEST_F(DatasetApp, ImportAndExportRoundTrip) {
  const std::string log = write("a.log", carmenLog(20));
  ASSERT_EQ(run({"import", log, path("b.rawlog")}), 0) << err.str();
  EXPECT_NE(out.str().find("20 steps"), std::string::npos);
  ASSERT_EQ(run({"export", path("b.rawlog"), path("c.log.gz")}), 0) << err.str();
  ASSERT_EQ(run({"export", "--flaser", path("b.rawlog"), path("d.log")}), 0) << err.str();
  for (const char* name : {"c.log.gz", "d.log"}) {
    const Result r = read(folder / name);
    ASSERT_EQ(r.steps.size(), 20U) << r.error;
    EXPECT_NEAR(r.steps[19].odom_from_robot.x, 9.5 * std::cos(0.1), 1e-6);  // from the origin
    EXPECT_EQ(r.steps[19].scan->getScanRange(3), 2.5F);
  }
}

TEST_F(DatasetApp, NoiseKeepsTheCleanPoses) {
  const std::string log = write("a.log", carmenLog(50));
  ASSERT_EQ(run({"noise", log, path("b.rawlog"), "--seed", "7", "--trans-trans", "0.2"}), 0)
      << err.str();
  const auto truth = io::readTum(folder / "b.rawlog.truth.tum");
  const Result clean = read(folder / "a.log");
  const Result noisy = read(folder / "b.rawlog");
  ASSERT_EQ(truth.size(), 50U);
  ASSERT_EQ(noisy.steps.size(), 50U) << noisy.error;
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(truth[i].time_s, clean.steps[i].time_s);
    EXPECT_NEAR(truth[i].pose.x, clean.steps[i].odom_from_robot.x, 1e-8);
  }
  const double error = (noisy.steps[49].odom_from_robot - TPose2D(24.5, 0, 0)).norm();
  EXPECT_GT(error, 0.01);
  ASSERT_EQ(run({"noise", log, path("c.rawlog"), "--seed", "7", "--trans-trans", "0.2"}), 0);
  EXPECT_EQ(io::readWhole(folder / "b.rawlog"), io::readWhole(folder / "c.rawlog"));
  ASSERT_EQ(run({"noise", log, path("d.rawlog"), "--seed", "8", "--trans-trans", "0.2"}), 0);
  EXPECT_NE(io::readWhole(folder / "b.rawlog"), io::readWhole(folder / "d.rawlog"));
}

TEST_F(DatasetApp, NoiseRestamps) {
  std::string text;
  for (int i = 0; i < 5; ++i) text += flaser(181, "1", "0 0 0", "0 0 0", kBegin_s);
  ASSERT_EQ(run({"noise", write("a.log", text), path("b.rawlog"), "--restamp", "0.5"}), 0);
  EXPECT_EQ(io::readTum(folder / "b.rawlog.truth.tum")[4].time_s, 2);
  EXPECT_NEAR(read(folder / "b.rawlog").steps.at(4).time_s, 2, 1e-6);
}

TEST_F(DatasetApp, RefusesToOverwriteUnlessTold) {
  const std::string log = write("a.log", carmenLog(5));
  const std::string taken = write("b", "mine");
  for (const char* command : {"import", "export", "noise"}) {
    EXPECT_EQ(run({command, log, taken}), 1);
    EXPECT_NE(err.str().find("exists; -w replaces it"), std::string::npos) << err.str();
    EXPECT_EQ(io::readWhole(folder / "b"), "mine");
  }
  write("c.truth.tum", "mine");
  EXPECT_EQ(run({"noise", log, path("c")}), 1);
  EXPECT_FALSE(fs::exists(folder / "c"));
  EXPECT_EQ(run({"import", log, taken, "-w"}), 0) << err.str();
  EXPECT_EQ(read(folder / "b").steps.size(), 5U);
}

TEST_F(DatasetApp, BadInputIsOneLineAndNoFile) {
  const std::string junk = write("a", "no log at all");
  for (const char* command : {"import", "export", "noise"}) {
    EXPECT_EQ(run({command, junk, path("b")}), 1);
    EXPECT_EQ(err.str().rfind("ariadne-dataset: ", 0), 0U) << err.str();
  }
  EXPECT_EQ(run({"info", path("missing")}), 1);
  EXPECT_EQ(files(), 1U);
}

TEST_F(DatasetApp, WarningsGoToTheErrorStream) {
  ASSERT_EQ(run({"import", write("a.log", carmenLog(5) + "FLASER x\n"), path("b")}), 0);
  EXPECT_NE(err.str().find("warning: 1 malformed lines"), std::string::npos) << err.str();
}

TEST_F(DatasetApp, WrongUseIsTwoHelpIsZero) {
  for (const std::vector<std::string>& args :
       std::vector<std::vector<std::string>>{{},
                                             {"dance"},
                                             {"info"},
                                             {"import", "a"},
                                             {"info", "a", "--what"},
                                             {"noise", "a", "b", "--rot-rot", "x"},
                                             {"noise", "a", "b", "--rot-rot", "-1"},
                                             {"noise", "a", "b", "--trans-rot", "nan"},
                                             {"noise", "a", "b", "--seed", "-1"}}) {
    EXPECT_EQ(run(args), 2);
    EXPECT_EQ(err.str().rfind("ariadne-dataset: ", 0), 0U) << err.str();
    EXPECT_EQ(out.str(), "");
  }
  for (const std::vector<std::string>& args :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"info", "--help"},
                                             {"import", "--help"},
                                             {"export", "--help"},
                                             {"noise", "--help"}}) {
    EXPECT_EQ(run(args), 0);
    EXPECT_NE(out.str().find("Example"), std::string::npos) << out.str();
  }
  EXPECT_EQ(run({"--version"}), 0);
}

TEST_F(DatasetApp, TheRealLogsCanBeMapped) {
  const auto intel = realLog("intel/intel-raw910.clf.gz");
  if (intel.empty()) GTEST_SKIP() << "intel-raw910.clf.gz is missing (set ARIADNE_DATASETS)";
  ASSERT_EQ(run({"info", intel.string(), "--json"}), 0) << err.str();
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json["counts"]["steps"], 910);
  EXPECT_NEAR(json["path_length_m"].get<double>(), 501, 1);
  EXPECT_TRUE(json["can_be_mapped"].get<bool>());
}
