#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "ariadne/batch/content_hash.h"
#include "ariadne/batch/plan.h"
#include "ariadne/core/error.h"
#include "stand_in.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

class Planning : public StandIn {
 protected:
  batch::Plan plan() { return batch::planOf(batch::readExperiment(ini())); }
  std::string message() {
    try {
      plan();
    } catch (const core::UsageError& e) {
      return e.what();
    }
    return "no error";
  }
  std::vector<std::string> keys() {
    std::vector<std::string> all;
    for (const auto& run : plan().runs) all.push_back(run.key);
    return all;
  }
};

}  // namespace

TEST_F(Planning, EverySeedHasAllArmsAtAllCombinations) {
  writeExperiment("[seeds]\nlast = 3\n[factor.p]\nkey = a.p\nvalues = 5, 6\n");
  const batch::Plan p = plan();
  ASSERT_EQ(p.runs.size(), 12U);
  EXPECT_EQ(batch::describe(p, p.runs[0]), "seed 1, p 5, first");
  EXPECT_EQ(batch::describe(p, p.runs[1]), "seed 1, p 5, second");
  EXPECT_EQ(batch::describe(p, p.runs[2]), "seed 1, p 6, first");
  EXPECT_EQ(batch::describe(p, p.runs[11]), "seed 3, p 6, second");
  const auto all = keys();
  EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), 12U);
  EXPECT_EQ(p.configs.size(), 4U);
  EXPECT_EQ(keys(), all) << "the same experiment, the same runs";
}

TEST_F(Planning, ARunIsAnotherWhenWhatMakesItChanged) {
  writeExperiment("[seeds]\nlast = 2\n");
  const auto before = keys();
  writeExperiment("[seeds]\nlast = 2\n[limits]\ntime_s = 9\n", "Other title");
  EXPECT_EQ(keys(), before) << "these do not make the result";
  io::writeWhole(folder / "arm.ini", std::string_view("[a]\n# a comment\nb=1\n[run]\nout = x\n"));
  EXPECT_EQ(keys(), before);
  io::writeWhole(folder / "arm.ini", std::string_view("[a]\nb = 2\n"));
  EXPECT_NE(keys()[0], before[0]);
  io::writeWhole(folder / "arm.ini", std::string_view("[a]\nb = 1\n"));
  EXPECT_EQ(keys(), before);
  writeProgram("# another version");
  EXPECT_NE(keys()[0], before[0]);
}

TEST_F(Planning, DataCountByWhatTheyHold) {
  const fs::path data = folder / "x.world";
  io::writeWhole(data, std::string_view("room"));
  writeExperiment("[factor.w]\nkey = --set\nvalues = x.world\n");
  io::writeWhole(folder / "arm.ini", "[world]\nfile = " + data.string() + "\n");
  const auto before = keys();
  const fs::path moved = folder / "y.world";
  fs::copy_file(data, moved);
  io::writeWhole(folder / "arm.ini", "[world]\nfile = " + moved.string() + "\n");
  EXPECT_EQ(keys(), before) << "the same under another name";
  io::writeWhole(moved, std::string_view("another room"));
  EXPECT_NE(keys()[0], before[0]);
  fs::remove(moved);
  EXPECT_NE(message().find("y.world: there is no such file"), std::string::npos) << message();
  EXPECT_NE(message().find("mrpt-common"), std::string::npos) << message();
}

TEST_F(Planning, ARosMapCountsWithItsPicture) {
  writeExperiment("[seeds]\nlast = 1\n");
  const fs::path map = folder / "my house.yaml";
  io::writeWhole(folder / "arm.ini", "[world]\nfile = " + map.string() + "\n");
  io::writeWhole(folder / "ground floor.pgm", std::string_view("a picture"));
  io::writeWhole(map, std::string_view("image: ground floor.pgm\nresolution: 0.05\n"));
  const auto before = keys();
  EXPECT_EQ(keys(), before);
  io::writeWhole(folder / "ground floor.pgm", std::string_view("another picture"));
  EXPECT_NE(keys()[0], before[0]);
}

TEST_F(Planning, PicturesOfRosMapsAreHashedHoweverTheyAreNamed) {
  const fs::path map = folder / "my house.yaml";
  const fs::path picture = folder / "ground floor.pgm";
  const auto hash = [&] { return batch::FileHashes().of(map); };
  for (const char* yaml :
       {"image: ground floor.pgm\r\nresolution: 0.05\r\n", "{image: ground floor.pgm}",
        "\xef\xbb\xbfimage: \"ground floor.pgm\"", "# a map\nimage:\n  'ground floor.pgm'  # here",
        "'image': ./ground floor.pgm"}) {
    io::writeWhole(map, std::string_view(yaml));
    io::writeWhole(picture, std::string_view("a picture"));
    const std::string before = hash();
    const std::string stamp = batch::stampOf(map);
    EXPECT_EQ(hash(), before);
    io::writeWhole(picture, std::string_view("b picture"));
    EXPECT_NE(hash(), before) << yaml;
    EXPECT_NE(batch::stampOf(map), stamp) << yaml;
  }
  // What is no map, or names no picture that is there, counts by itself.
  for (const char* yaml : {"image: none.pgm", "a: [", "just: a file"}) {
    io::writeWhole(map, std::string_view(yaml));
    EXPECT_EQ(hash(), batch::hashOf(yaml)) << yaml;
  }
}

TEST_F(Planning, ARecordingInAFolderCountsByItsParts) {
  const fs::path drive = folder / "drive";
  const auto put = [&](const char* name, const std::string& content) {
    io::writeWhole(drive / name, content);
  };
  const std::string mcap("\x89MCAP0\r\n", 8);
  fs::create_directories(drive);
  const std::string text = "[arm.third]\nprogram = ./program.sh\nconfig = arm.ini\n";
  writeExperiment(text + "dataset = drive\n");
  EXPECT_NE(message().find("drive is a directory and no recording of ROS"), std::string::npos)
      << message();
  put("drive_0.mcap", mcap + "one");
  put("drive_1.mcap", mcap + "two");
  const auto key = [&] { return keys()[2]; };
  for (const char* named : {"drive", "drive/metadata.yaml"}) {
    SCOPED_TRACE(named);
    put("metadata.yaml",
        "rosbag2_bagfile_information:\n  relative_file_paths: [drive_0.mcap, drive_1.mcap]\n");
    io::writeWhole(folder / "arm.ini",
                   fmt::format("[dataset]\nfile = {}\n", (folder / named).string()));
    writeExperiment(text + fmt::format("set.dataset.file = {}\n", named));
    const std::string before = key();
    const std::string stamp = batch::stampOf(folder / named);
    EXPECT_EQ(key(), before);
    put("drive_1.mcap", mcap + "other");
    EXPECT_NE(key(), before);
    EXPECT_NE(batch::stampOf(folder / named), stamp);
    put("drive_1.mcap", mcap + "two");
    EXPECT_EQ(key(), before);
    put("metadata.yaml",
        "rosbag2_bagfile_information:\n  relative_file_paths: [drive_1.mcap, drive_0.mcap]\n");
    EXPECT_NE(key(), before) << "the order of the parts";
  }
  io::writeWhole(folder / "arm.ini", fmt::format("[dataset]\nfile = {}\n", drive.string()));
  fs::remove(drive / "drive_0.mcap");
  EXPECT_NE(message().find("names the file drive_0.mcap, which is not there"), std::string::npos)
      << message();
}

TEST_F(Planning, WhatProgramsPrintLiesWhereOthersCannotPutALink) {
  const fs::path tmp = folder / "tmp";
  fs::create_directories(tmp);
  io::writeWhole(folder / "victim", std::string_view("precious"));
  fs::create_symlink(folder / "victim", tmp / fmt::format("ariadne-config-{}.ini", ::getpid()));
  ::setenv("TMPDIR", tmp.c_str(), 1);
  const auto all = keys();
  ::unsetenv("TMPDIR");
  EXPECT_EQ(all.size(), 20U);
  EXPECT_EQ(io::readWhole(folder / "victim"), "precious");
  EXPECT_EQ(std::distance(fs::directory_iterator(tmp), {}), 1) << "nothing of ours is left";
}

TEST_F(Planning, ArgumentsMayHoldBlanks) {
  writeExperiment(
      "[arm.third]\nprogram = ./program.sh\nconfig = arm.ini\n"
      "args = --set w=\"my house.yaml\" --set  x=1\n");
  const auto x = batch::readExperiment(ini());
  EXPECT_EQ(x.arms[2].args, (std::vector<std::string>{"--set", "w=my house.yaml", "--set", "x=1"}));
  writeExperiment("[arm.third]\nprogram = ./program.sh\nconfig = arm.ini\nargs = -a \"b c\n");
  EXPECT_NE(message().find("has no closing quote"), std::string::npos) << message();
}

TEST_F(Planning, ATypoInAnyArmFailsThePlan) {
  writeExperiment("[arm.third]\nprogram = ./program.sh\nconfig = arm.ini\nset.a.typo = 1\n");
  const std::string said = message();
  EXPECT_NE(said.find("experiment.ini:13: [arm.third]"), std::string::npos) << said;
  EXPECT_NE(said.find("there is no such key"), std::string::npos) << said;
}

TEST_F(Planning, AFactorsValueSetsManyKeys) {
  io::writeWhole(folder / "x.world", std::string_view("room"));
  writeExperiment(
      "[seeds]\nlast = 1\n[factor.n]\nvalues = 1, 0.5\nset.0.5.a.p = 7\nset.0.5.a.q = x.world\n");
  const batch::Plan p = plan();
  ASSERT_EQ(p.runs.size(), 4U);
  EXPECT_EQ(batch::describe(p, p.runs[2]), "seed 1, n 0.5, first");
  const std::string settings = "all =  a.p=7 a.q=" + (folder / "x.world").string();
  EXPECT_EQ(p.configs.at(p.runs[0].config).find("a.p"), std::string::npos);
  EXPECT_NE(p.configs.at(p.runs[2].config).find(settings), std::string::npos)
      << p.configs.at(p.runs[2].config);
  writeExperiment("[factor.n]\nvalues = 1\nset.1.a.q = none/x.world\n");
  EXPECT_NE(message().find("[factor.n] set.1.a.q: there is no file none/x.world"),
            std::string::npos)
      << message();
  writeExperiment("[factor.n]\nvalues = 1\nset.1.a.typo = 3\n");
  EXPECT_NE(message().find("there is no such key"), std::string::npos) << message();
}

TEST_F(Planning, ErrorsNameWhatIsMissing) {
  const std::string arm = "[arm.third]\nconfig = arm.ini\n";
  writeExperiment(arm + "program = ariadne-slma\n");
  EXPECT_NE(message().find("ariadne-slam, "), std::string::npos) << message();
  writeExperiment(arm + "program = ./none.sh\n");
  EXPECT_NE(message().find("no executable"), std::string::npos) << message();
  writeExperiment("[arm.third]\nconfig = none.ini\nprogram = ./program.sh\n");
  EXPECT_NE(message().find("none.ini: there is no file"), std::string::npos) << message();
  writeExperiment(arm + "program = ./program.sh\ndataset = none.rawlog\n");
  EXPECT_NE(message().find("none.rawlog: there is no such file"), std::string::npos) << message();
  writeExperiment("[factor.w]\nkey = --world\nvalues = none/x.world\n");
  EXPECT_NE(message().find("[factor.w] values: there is no file none/x.world"), std::string::npos)
      << message();
  std::string factors;  // 1e12 combinations: told before any of them is made
  for (int i = 0; i < 12; ++i)
    factors += fmt::format("[factor.f{0}]\nkey = a.k{0}\nvalues = 0,1,2,3,4,5,6,7,8,9\n", i);
  writeExperiment(factors);
  EXPECT_NE(message().find("2e+13 runs are more than 1000000"), std::string::npos) << message();
  writeExperiment("[seeds]\nfirst = 0\nlast = 999999999\n");
  EXPECT_NE(message().find("fewer seeds"), std::string::npos) << message();
}

TEST_F(Planning, ArmsThatAskTheSameShareARun) {
  writeExperiment("[arm.third]\nprogram = ./program.sh\nconfig = arm.ini\nprefix = x_\n");
  const batch::Plan p = plan();
  EXPECT_EQ(p.runs[0].key, p.runs[2].key);
  EXPECT_NE(p.runs[0].key, p.runs[1].key);
}
