// ariadne-dataset simulate and world.
#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/sim/drive.h"
#include "dataset_app.h"

namespace fs = std::filesystem;
namespace io = ariadne::io;
namespace sim = ariadne::sim;

namespace {

const char* const kWorld = "corridor 2 0 0 6 0 6 4\nwall 3 0.7 3.3 1\nstart 0 0 0\n";
const char* const kPath =
    "laps 0\nmark A\ngoto 6 0\ngoto 6 4\nrepeat laps\ngoto 6 0\ngoto 6 4\nend\nmark C\n";

}  // namespace

class SimulateApp : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    io::writeWhole(folder / "a.world", kWorld);
    io::writeWhole(folder / "a.path", kPath);
  }
  int run(const std::vector<std::string>& args) {
    out.str("");
    err.str("");
    return ariadne::runDatasetApp(args, out, err);
  }
  /// simulate a.world a.path NAME OPTIONS
  int simulate(const char* name, const std::vector<std::string>& options = {}) {
    std::vector<std::string> args = {"simulate", path("a.world"), path("a.path"), path(name)};
    args.insert(args.end(), options.begin(), options.end());
    return run(args);
  }
  std::string path(const char* name) const { return (folder / name).string(); }
  std::string text(const char* name) const { return io::readWhole(folder / name); }
  std::size_t files() const { return std::distance(fs::directory_iterator(folder), {}); }
  std::ostringstream out, err;
};

TEST_F(SimulateApp, TheRawlogHoldsWhatWasSeen) {
  ASSERT_EQ(
      simulate("b.rawlog", {"--laps", "2", "--seed", "5", "--set", "noise.travel_per_root_m=0.1"}),
      0)
      << err.str();
  const auto world = sim::readWorld(folder / "a.world");
  const auto drive = sim::driveThrough(world, sim::readPath(folder / "a.path", 2), {});
  sim::NoiseParams noise;
  noise.travel_per_root_m = 0.1;
  const auto seen = sim::observe(drive, noise, 5);

  const auto steps = io::openDataset(folder / "b.rawlog");
  for (std::size_t k = 0; k < seen.steps.size(); ++k) {
    const auto step = steps->next();
    ASSERT_TRUE(step) << k;
    EXPECT_NEAR(step->time_s, seen.steps[k].time_s, 1e-6);  // MRPT's stamps are 1e-7 s
    EXPECT_LT((step->odom_from_robot - seen.steps[k].odom_from_robot).norm(), 1e-9);
    ASSERT_EQ(step->scan->getScanSize(), 181U);
    for (std::size_t i = 0; i < 181; ++i) {
      EXPECT_EQ(step->scan->getScanRange(i), seen.steps[k].scan->getScanRange(i));
      EXPECT_EQ(step->scan->getScanRangeValidity(i), seen.steps[k].scan->getScanRangeValidity(i));
    }
  }
  EXPECT_FALSE(steps->next());
  EXPECT_TRUE(steps->warnings().empty());

  const auto truth = io::readTum(folder / "b.rawlog.truth.tum");
  ASSERT_EQ(truth.size(), drive.poses.size());
  EXPECT_NEAR(truth.back().pose.y, drive.poses.back().pose.y, 1e-8);
}

TEST_F(SimulateApp, TruthSaysHowItWasMadeAndMarksWhen) {
  ASSERT_EQ(simulate("b.rawlog", {"--laps", "1", "--set", "drive.beams=91"}), 0) << err.str();
  EXPECT_NE(text("b.rawlog.truth.tum")
                .find("simulate a.world a.path b.rawlog --seed 1 --laps 1 --set drive.beams=91"),
            std::string::npos);
  const std::string marks = text("b.rawlog.marks.csv");
  EXPECT_EQ(marks.rfind("name,time_s\nA,0.000\nC,", 0), 0U) << marks;
  for (const char* part : {" scans, ", " m, ", " s; wrote ", "b.rawlog.truth.tum", "marks.csv"})
    EXPECT_NE(out.str().find(part), std::string::npos) << out.str();
}

TEST_F(SimulateApp, SameSeedSameFile) {
  ASSERT_EQ(simulate("b", {"--seed", "7"}), 0) << err.str();
  ASSERT_EQ(simulate("c", {"--seed", "7"}), 0);
  ASSERT_EQ(simulate("d", {"--seed", "8"}), 0);
  EXPECT_EQ(text("b"), text("c"));
  EXPECT_NE(text("b"), text("d"));
  EXPECT_EQ(text("b.marks.csv"), text("d.marks.csv"));
}

TEST_F(SimulateApp, RefusesToOverwriteUnlessTold) {
  for (const char* taken : {"b", "b.truth.tum", "b.marks.csv"}) {
    io::writeWhole(folder / taken, "mine");
    EXPECT_EQ(simulate("b"), 1);
    EXPECT_NE(err.str().find("exists; -w replaces it"), std::string::npos) << err.str();
    EXPECT_EQ(text(taken), "mine");
    fs::remove(folder / taken);
  }
  io::writeWhole(folder / "b", "mine");
  EXPECT_EQ(simulate("b", {"-w"}), 0) << err.str();
  EXPECT_NE(text("b"), "mine");
}

TEST_F(SimulateApp, BadInputIsOneLineAndNoFile) {
  io::writeWhole(folder / "a.path", "goto 6 0\ngoto 3 3\n");
  EXPECT_EQ(simulate("b"), 1);
  EXPECT_NE(err.str().find("touches rock"), std::string::npos) << err.str();
  io::writeWhole(folder / "a.path", "goto 6 0\njump 3 3\n");
  EXPECT_EQ(simulate("b"), 1);
  EXPECT_NE(err.str().find("a.path:2"), std::string::npos) << err.str();
  EXPECT_EQ(run({"simulate", path("none"), path("a.path"), path("b")}), 1);
  EXPECT_EQ(run({"world", path("a.path"), path("b.png")}), 1);
  EXPECT_EQ(files(), 2U);
}

TEST_F(SimulateApp, WrongUseIsTwoHelpIsZero) {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--set", "drive.beam=3"},
                                             {"--set", "drives.beams=3"},
                                             {"--set", "drive.beams=1"},
                                             {"--set", "beams=3"},
                                             {"--laps", "-1"},
                                             {"--laps", "x"},
                                             {"--seed", "-1"},
                                             {"--what"}}) {
    EXPECT_EQ(simulate("b", options), 2) << options.back();
    EXPECT_EQ(err.str().rfind("ariadne-dataset: ", 0), 0U) << err.str();
  }
  io::writeWhole(folder / "a.path", "goto 6 0\n");
  EXPECT_EQ(simulate("b", {"--laps", "2"}), 2) << "laps that make no difference";
  EXPECT_EQ(run({"world", path("a.world"), path("b.png"), "--laps", "2"}), 2);
  EXPECT_EQ(files(), 2U);
  for (const char* command : {"simulate", "world"}) {
    EXPECT_EQ(run({command, "--help"}), 0);
    EXPECT_NE(out.str().find("Example"), std::string::npos) << out.str();
  }
}

TEST_F(SimulateApp, WorldDrawsAPicture) {
  ASSERT_EQ(run({"world", path("a.world"), path("b.png")}), 0) << err.str();
  ASSERT_EQ(run({"world", path("a.world"), path("c.png"), "--path", path("a.path")}), 0);
  EXPECT_EQ(text("b.png").substr(1, 3), "PNG");
  EXPECT_NE(text("b.png"), text("c.png"));
  EXPECT_EQ(run({"world", path("a.world"), path("b.png")}), 1);
  EXPECT_NE(err.str().find("exists"), std::string::npos);
}

TEST_F(SimulateApp, WorldDrawsARandomOne) {
  ASSERT_EQ(run({"world", "--random", "office", "--seed", "7", path("o.world"), path("o.png")}), 0)
      << err.str();
  EXPECT_EQ(text("o.png").substr(1, 3), "PNG");
  EXPECT_EQ(text("o.world").rfind("# ariadne-dataset world --random office --seed 7", 0), 0U);
  ASSERT_EQ(run({"world", "--random", "corridors", path("c.world")}), 0) << err.str();
  EXPECT_EQ(run({"world", "--random", "corridors", path("c.world")}), 1);
  EXPECT_NE(err.str().find("exists"), std::string::npos);
  EXPECT_EQ(run({"world", "--random", "castle", path("d.world")}), 2);
  EXPECT_NE(err.str().find("office"), std::string::npos) << err.str();
  EXPECT_EQ(run({"world", path("o.world")}), 2);
  EXPECT_NE(err.str().find("OUT"), std::string::npos) << err.str();
}

TEST_F(SimulateApp, TheCommittedLogIsWhatItsRecipeMakes) {
  const fs::path datasets = ariadne::test::shippedDatasets();
  ASSERT_EQ(run({"simulate", (datasets / "worlds/small.world").string(),
                 (datasets / "drives/small.path").string(), path("small.rawlog"), "--seed", "1"}),
            0)
      << err.str();
  const auto made = io::openDataset(folder / "small.rawlog");
  const auto committed = io::openDataset(datasets / "drives/small.rawlog");
  while (const auto step = committed->next()) {
    const auto same = made->next();
    ASSERT_TRUE(same);
    // Another libm may round otherwise.
    EXPECT_LT((step->odom_from_robot - same->odom_from_robot).norm(), 1e-6);
    EXPECT_NEAR(step->scan->getScanRange(90), same->scan->getScanRange(90), 0.051);
  }
  EXPECT_FALSE(made->next());
  EXPECT_EQ(committed->counts().steps, 663U);
}
