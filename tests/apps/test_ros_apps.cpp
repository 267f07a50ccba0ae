// ROS recordings through the programs: what info says, import and export, the shipped ros.ini.
#include <nlohmann/json.hpp>
#include <sstream>

#include "../io/ros/recording.h"
#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/whole_file.h"
#include "dataset_app.h"
#include "slam_app.h"

namespace fs = std::filesystem;
using namespace ariadne;

namespace {

const fs::path kSamples = test::shippedDatasets() / "ros";

class RosApps : public TemporaryFolder {
 protected:
  int dataset(const std::vector<std::string>& args) {
    std::ostringstream out_stream, err_stream;
    const int code = runDatasetApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }
  int slam(std::vector<std::string> args) {
    const fs::path ini = test::shippedDatasets() / "../ini/slam/ros.ini";
    args.insert(args.begin(), ini.string());
    args.insert(args.end(),
                {"--particles", "4", "--no-pictures", "--overwrite", "--out", path("run")});
    std::ostringstream out_stream, err_stream;
    const int code = runSlamApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string put(const std::string& name, const recording::Mcap& file) const {
    io::writeWhole(folder / name, file.bytes());
    return path(name);
  }
  void expectOut(const std::vector<std::string>& parts) const {
    for (const std::string& part : parts)
      EXPECT_NE(out.find(part), out.npos) << part << "\n" << out;
  }
  std::string out, err;
};

}  // namespace

TEST_F(RosApps, InfoListsTopicsWithTypesAndCounts) {
  ASSERT_EQ(dataset({"info", (kSamples / "odom.bag").string()}), 0) << err;
  expectOut({"ROS 1 bag", "19 /odom (nav_msgs/Odometry)", "19 /scan (sensor_msgs/LaserScan)",
             "1 /tf_static (tf2_msgs/TFMessage)", "odometry: 19 readings", "laser /scan: 19 scans",
             "at x 0.200 y 0.000 z 0.250 m", "note: odometry: /odom, odom -> base_footprint",
             "note: the laser on the robot: base_footprint -> base_link, base_link -> laser",
             "can be mapped: yes"});
  ASSERT_EQ(dataset({"info", (kSamples / "split").string(), "--json"}), 0) << err;
  const auto json = nlohmann::json::parse(out);
  EXPECT_EQ(json["format"], "MCAP recording");
  EXPECT_EQ(json["holds"]["/scan (sensor_msgs/msg/LaserScan)"], 19);
  EXPECT_GT(json["bytes"], 5000);
}

TEST_F(RosApps, InfoSaysWhatIsMissing) {
  ASSERT_EQ(dataset({"info", put("a.mcap", recording::drive())}), 0) << err;
  expectOut({"where it is on the robot is not known", "can be mapped: no: where the laser is"});
  ASSERT_EQ(dataset({"info", path("a.mcap"), "--laser-pose", "0.1 0 0"}), 0) << err;
  expectOut({"at x 0.100", "can be mapped: yes"});
  const auto clouds = recording::Mcap().message("/points", "sensor_msgs/PointCloud2", "", {1, 0});
  ASSERT_EQ(dataset({"info", put("b.mcap", clouds)}), 0) << err;
  expectOut({"1 /points (sensor_msgs/PointCloud2)", "can be mapped: no: no sensor_msgs/LaserScan"});
}

TEST_F(RosApps, InfoOfSeveralLasersDescribesAll) {
  auto file = recording::drive({"front", "rear"});
  file.fixed({{"base", "front", {}}, {"base", "rear", {}}});
  ASSERT_EQ(dataset({"info", put("a.mcap", file)}), 0) << err;
  expectOut({"laser /front/scan: 4 scans", "laser /rear/scan: 4 scans",
             "can be mapped: yes, with one of the lasers chosen"});
  EXPECT_EQ(dataset({"import", path("a.mcap"), path("a.rawlog")}), 1);
  EXPECT_NE(err.find("choose one by [dataset] scan_topic"), err.npos) << err;
  EXPECT_EQ(dataset({"import", path("a.mcap"), path("a.rawlog"), "--laser", "/rear/scan"}), 0)
      << err;
}

TEST_F(RosApps, ImportAndExport) {
  const std::string bag = (kSamples / "tf_bz2.bag").string();
  ASSERT_EQ(dataset({"import", bag, path("a.rawlog")}), 0) << err;
  EXPECT_EQ(out, path("a.rawlog") + ": 19 steps\n");
  ASSERT_EQ(dataset({"export", bag, path("a.log")}), 0) << err;
  for (const char* name : {"a.rawlog", "a.log"}) {
    const auto made = io::openDataset(path(name)), from = io::openDataset(bag);
    while (const auto step = from->next()) {
      const auto same = made->next();
      ASSERT_TRUE(same);
      EXPECT_NEAR(same->time_s, step->time_s, 1e-6);
      for (std::size_t i = 0; i < 61; ++i)
        EXPECT_EQ(same->scan->getScanRange(i), step->scan->getScanRange(i));
    }
  }
}

TEST_F(RosApps, ShippedIniMapsARecording) {
  ASSERT_EQ(slam({(kSamples / "tf.db3").string()}), 0) << err;
  EXPECT_EQ(err.find("warning"), err.npos) << err;
  const auto summary = nlohmann::json::parse(io::readWhole(folder / "run/summary.json"));
  EXPECT_EQ(summary["dataset"]["laser"], "/scan") << summary.dump(1);
  // A folder maps as well, and from config.ini again.
  ASSERT_EQ(slam({(kSamples / "split").string()}), 0) << err;
  const std::string map = io::readWhole(folder / "run/map.pgm");
  const fs::path again = folder / "again.ini";
  fs::copy_file(folder / "run/config.ini", again);
  std::ostringstream ignored, told;
  ASSERT_EQ(runSlamApp({again.string(), "--out", path("again")}, ignored, told), 0) << told.str();
  EXPECT_EQ(io::readWhole(folder / "again/map.pgm"), map);
}

TEST_F(RosApps, TopicsAndFramesAreSettings) {
  auto file = recording::drive({"front", "rear"});
  for (std::uint32_t i = 0; i < 4; ++i)
    file.odom({1000 + i, 0}, recording::turned(0.3 * i, 0, 0), "base", "/odom2");
  const std::string log = put("a.mcap", file);
  EXPECT_EQ(slam({log}), 1);
  EXPECT_NE(err.find("several lasers"), err.npos) << err;
  EXPECT_EQ(slam({log, "--set", "dataset.scan_topic=/rear/scan"}), 1);
  EXPECT_NE(err.find("several topics with odometry"), err.npos) << err;
  const std::vector<std::string> chosen = {
      log, "--set", "dataset.scan_topic=/rear/scan", "--set", "dataset.odom_topic=/odom2", "--set"};
  auto args = chosen;
  args.emplace_back("dataset.laser_pose=somewhere");
  EXPECT_EQ(slam(args), 2);
  EXPECT_NE(err.find("[dataset] laser_pose = somewhere: it takes x and y"), err.npos) << err;
  args.back() = "dataset.laser_pose=0 0 90";
  EXPECT_EQ(slam(args), 0) << err;
}
