// Recordings in several files: folders with metadata.yaml and without.
#include "ros_log.h"

namespace fs = std::filesystem;
using sample::io::readWhole;
using sample::io::writeWhole;

namespace {

class RosFolder : public RosLog {};

}  // namespace

TEST_F(RosFolder, AFolderWithoutMetadataIsItsParts) {
  for (const char* name : {"split_0.mcap", "split_1.mcap"})
    fs::copy_file(kRecordings / "split" / name, folder / name);
  const auto r = sample::read(folder);
  EXPECT_EQ(r.steps.size(), sample::read(kRecordings / "split").steps.size());
  EXPECT_TRUE(r.warns("there is no metadata.yaml: the 2 recordings"));
  fs::copy_file(kRecordings / "tf.mcap", folder / "other.mcap");
  expectTold(sample::read(folder), {"holds several recordings", "name one file"});
}

TEST_F(RosFolder, APartThatIsMissingIsTold) {
  fs::copy_file(kRecordings / "split/metadata.yaml", folder / "metadata.yaml");
  fs::copy_file(kRecordings / "split/split_0.mcap", folder / "split_0.mcap");
  expectTold(sample::read(folder),
             {"metadata.yaml names the file split_1.mcap, which is not there"});
}

TEST_F(RosFolder, AfterADamagedPartTheNextGoesOn) {
  fs::copy(kRecordings / "split", folder / "split");
  const std::string first = readWhole(folder / "split/split_0.mcap");
  writeWhole(folder / "split/split_0.mcap", first.substr(0, first.size() / 2));
  const auto r = sample::read(folder / "split");
  EXPECT_GT(r.steps.size(), 8U);
  EXPECT_TRUE(r.warns("of split_0.mcap"));
  EXPECT_TRUE(r.warns("the next one goes on"));
}

TEST_F(RosFolder, BadMetadataIsTold) {
  writeWhole(folder / "metadata.yaml", "rosbag2_bagfile_information:\n  version: 5\n");
  expectTold(sample::read(folder), {"metadata.yaml", "relative_file_paths"});
  writeWhole(folder / "metadata.yaml", "rosbag2_bagfile_information:\n  relative_file_paths: []\n");
  expectTold(sample::read(folder), {"no file is named"});
}

TEST_F(RosFolder, ThePlaceOfTheSecondPartAlone) {
  expectTold(sample::read(kRecordings / "split/split_1.mcap"),
             {"tf_static is in the first one", "laser_pose"});
}

TEST_F(RosFolder, ManyPartsGoByTheirNumbers) {
  // Ten drives of four scans, so that part 10 comes after part 9 and not after part 1.
  for (std::uint32_t part = 0; part <= 10; ++part) {
    recording::Mcap file;
    if (part == 0) file.fixed({{"base", "laser", {}}});
    for (std::uint32_t i = 0; i < 2; ++i) {
      recording::Scan scan;
      scan.stamp = {1000 + 2 * part + i, 0};
      file.odom(scan.stamp, recording::turned(2 * part + i, 0, 0)).scan(scan);
    }
    writeWhole(folder / fmt::format("drive_{}.mcap", part), file.bytes());
  }
  const auto r = sample::read(folder);
  ASSERT_EQ(r.steps.size(), 22U);
  for (std::size_t i = 0; i < 22; ++i) EXPECT_EQ(r.steps[i].time_s, 1000.0 + i);
}

TEST_F(RosFolder, OldMetadataNamesTheFolderToo) {
  fs::copy(kRecordings / "split", folder / "split");
  std::string yaml = readWhole(folder / "split/metadata.yaml");
  for (std::size_t at = 0; (at = yaml.find("- split_", at)) != yaml.npos; at += 10)
    yaml.insert(at + 2, "split/");
  writeWhole(folder / "split/metadata.yaml", yaml);
  EXPECT_EQ(sample::read(folder / "split").error, "");
}
