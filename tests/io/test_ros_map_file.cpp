// The YAML of a ROS map.
#include <gtest/gtest.h>

#include <cmath>

#include "../sim/expect_error.h"
#include "ariadne/core/error.h"
#include "ariadne/io/ros_map_file.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

using namespace ariadne;
using Mode = io::RosMapFile::Mode;
using test::expectError;

namespace {

class RosMapYaml : public TemporaryFolder {
 protected:
  io::RosMapFile read(const std::string& yaml) const {
    io::writeWhole(folder / "m.yaml", yaml);
    return io::readRosMapFile(folder / "m.yaml");
  }
  /// A good one with the line of `key` replaced; an empty line takes it out.
  std::string with(const std::string& key, const std::string& line) const {
    std::string text;
    for (const std::string good : {"image: m.pgm", "resolution: 0.05", "origin: [-1.5, 2, 0.5]",
                                   "negate: 0", "occupied_thresh: 0.65", "free_thresh: 0.196"})
      text += (good.rfind(key + ":", 0) == 0 ? line : good) + "\n";
    return text;
  }
  void refused(const std::string& key, const std::string& line,
               const std::vector<std::string>& parts) const {
    std::vector<std::string> all = parts;
    all.push_back("m.yaml:");
    expectError<core::Error>([&] { read(with(key, line)); }, all);
  }
};

}  // namespace

TEST_F(RosMapYaml, EachKeyIsRead) {
  const auto map = read(with("", ""));
  EXPECT_EQ(map.picture, folder / "m.pgm");
  EXPECT_EQ(map.mode, Mode::trinary);
  EXPECT_EQ(map.resolution_m, 0.05);
  EXPECT_EQ(map.map_from_picture, mrpt::math::TPose2D(-1.5, 2, 0.5));
  EXPECT_FALSE(map.negate);
  EXPECT_EQ(map.occupied_thresh, 0.65);
  EXPECT_EQ(map.free_thresh, 0.196);
  EXPECT_TRUE(read(with("negate", "negate: 1")).negate);
  EXPECT_TRUE(read(with("negate", "negate: true")).negate);
  EXPECT_EQ(read(with("negate", "negate: 0\nmode: Scale")).mode, Mode::scale);
  EXPECT_EQ(read(with("negate", "negate: 0\nmode: raw")).mode, Mode::raw);
  EXPECT_EQ(read(with("image", "image: 'sub folder/a: b #1.pgm'")).picture,
            folder / "sub folder/a: b #1.pgm");
  EXPECT_EQ(read(with("image", "image: /abs/m.pgm")).picture, "/abs/m.pgm");
  EXPECT_EQ(read(with("image", "image: my map.pgm   # beside")).picture, folder / "my map.pgm");
  EXPECT_NEAR(read(with("origin", "origin: [0, 0, 4.0]")).map_from_picture.phi, 4 - 2 * M_PI, 1e-9);
}

TEST_F(RosMapYaml, EachKeyMustBeThere) {
  for (const char* key :
       {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"})
    refused(key, "", {std::string(key) + " is missing, as in " + key + ": "});
}

TEST_F(RosMapYaml, WhatIsWrongIsNamed) {
  for (const char* value : {"-0.05", ".nan", "1e-30", ".inf", "five", "[0.05]", "", "0.05 m"})
    refused("resolution", std::string("resolution: ") + value,
            {":2: resolution: ", "takes a number from 0.005 to 0.5"});
  refused("origin", "origin: [0, 0]", {"origin: 2 values; takes 3, x and y in m and yaw in rad"});
  refused("origin", "origin: [0, 0, 0, 0]", {"origin: 4 values"});
  refused("origin", "origin: 0", {"origin: \"0\" where a list belongs"});
  refused("origin", "origin: [0, 1e30, 0]", {"origin[1]: \"1e30\"; takes a number from -100000"});
  refused("origin", "origin: [0, 0, 90]", {"origin[2]: \"90\"; takes a number from -6.2832"});
  refused("negate", "negate: 2", {"negate: \"2\"; takes 0, 1, true or false"});
  refused("negate", "negate: 1\nmode: raw", {"negate: goes with modes trinary and scale"});
  refused("negate", "negate: 0\nmode: grey", {"mode: \"grey\"; takes trinary, scale or raw"});
  refused("image", "image: ''", {"image: names no file"});
  refused("image", "image: [m.pgm]", {"image: a list where a text belongs"});
  refused("free_thresh", "free_thresh: 25", {"free_thresh: \"25\"; takes a number from 0 to 1"});
  refused("free_thresh", "free_thresh: 0.9", {"free_thresh: 0.9 is over occupied_thresh, 0.65"});
  expectError<core::Error>([&] { read("- image: m.pgm\n"); },
                           {"m.yaml:1: a list where lines of key: value belong"});
}

TEST_F(RosMapYaml, PicturesAreFoundForWhoOnlyHashesThem) {
  io::writeWhole(folder / "my map.pgm", std::string_view("x"));
  io::writeWhole(folder / "m.yaml", std::string_view("{\"image\": my map.pgm}"));
  EXPECT_EQ(io::pictureOfRosMap(folder / "m.yaml"), folder / "my map.pgm");
  for (const char* other : {"image: none.pgm", "a: 1", "[", "image: [my map.pgm]", ""}) {
    io::writeWhole(folder / "m.yaml", std::string_view(other));
    EXPECT_FALSE(io::pictureOfRosMap(folder / "m.yaml")) << other;
  }
  EXPECT_FALSE(io::pictureOfRosMap(folder / "none.yaml"));
}
