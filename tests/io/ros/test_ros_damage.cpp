// Broken recordings: what stands before the damage is read, and nothing that they claim is
// believed.
#include <sys/resource.h>

#include "ros_log.h"

namespace fs = std::filesystem;
using recording::drive;
using recording::Mcap;
using recording::Packed;
using sample::io::readWhole;
using sample::io::writeWhole;

namespace {

const std::vector<recording::Tf> kAtTheMiddle = {{"base", "laser", {}}};

class RosDamage : public RosLog {
 protected:
  static long peak_kb() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  }
};

/// A recording of `count` drives one behind the other.
std::string whole() { return Mcap(drive().fixed(kAtTheMiddle)).bytes(); }

}  // namespace

TEST_F(RosDamage, CutAnywhereItGivesWhatIsBefore) {
  for (const char* name : {"odom.bag", "tf_bz2.bag", "tf.mcap", "tf_lz4.mcap", "odom_zstd.mcap"}) {
    const std::string bytes = readWhole(kRecordings / name);
    const std::size_t all = sample::read(kRecordings / name).steps.size();
    std::size_t before = 0;
    for (int tenth = 1; tenth <= 9; ++tenth) {
      writeWhole(folder / name,
                 bytes.substr(0, bytes.size() * static_cast<std::size_t>(tenth) / 10));
      const auto r = sample::read(folder / name);
      EXPECT_GE(r.steps.size(), before) << name << " " << tenth;
      before = r.steps.size();
      // Cut within the summary at the end, nothing is lost and nothing need be said.
      if (r.steps.empty() || r.steps.size() == all) continue;
      EXPECT_TRUE(r.warns("damaged at") || r.warns("not closed")) << name << " " << tenth;
    }
    EXPECT_GT(before, 10U) << name;
  }
}

TEST_F(RosDamage, AFileThatWasNotClosedIsRead) {
  const auto r = read(drive().fixed(kAtTheMiddle).bytes(false));
  EXPECT_EQ(r.steps.size(), 4U);
  EXPECT_TRUE(r.warns("not closed by its recorder"));
  EXPECT_FALSE(read(whole()).warns("not closed"));
}

// The last 4 KB of a bag are its index; its place in the header is 0 until the recorder closes it.
TEST_F(RosDamage, ABagWithoutIndexIsRead) {
  std::string bytes = readWhole(kRecordings / "odom.bag");
  const std::size_t index = bytes.find("index_pos=") + 10;
  std::uint64_t at = 0;
  std::memcpy(&at, bytes.data() + index, sizeof at);
  bytes.resize(at);
  std::memset(bytes.data() + index, 0, sizeof at);
  writeWhole(folder / "a.bag", bytes);
  const auto r = sample::read(folder / "a.bag");
  EXPECT_EQ(r.steps.size(), sample::read(kRecordings / "odom.bag").steps.size());
  EXPECT_TRUE(r.warns("not closed by its recorder"));
}

TEST_F(RosDamage, AWrongChecksumIsDamage) {
  std::string bytes = readWhole(kRecordings / "tf.mcap");
  const std::size_t in_last_scan = bytes.rfind("laser") + 60;
  bytes[in_last_scan] = static_cast<char>(bytes[in_last_scan] ^ 1);
  const auto r = read(bytes);
  EXPECT_GT(r.steps.size(), 3U);
  EXPECT_TRUE(r.warns("checksum is wrong; what follows is lost"));
}

TEST_F(RosDamage, HugeClaimsTakeNoMemory) {
  const long before = peak_kb();
  const std::uint64_t huge = 1ULL << 62;
  std::vector<std::string> files;
  for (const unsigned char op : {3, 4, 5, 6, 9})
    files.push_back(Mcap().bytes(false) + Packed().add(op).add(huge).raw("abc").bytes());
  for (const char* codec : {"", "lz4", "zstd"})
    files.push_back(Mcap()
                        .record(6, Packed()
                                       .add<std::uint64_t>(0)
                                       .add<std::uint64_t>(0)
                                       .add<std::uint64_t>(1ULL << 29)
                                       .add<std::uint32_t>(1)
                                       .text(codec)
                                       .add<std::uint64_t>(4)
                                       .raw("abcd"))
                        .bytes());
  Packed scan = recording::header({1000, 0}, "laser");
  for (int i = 0; i < 7; ++i) scan.add(1.F);
  scan.add<std::uint32_t>(0xffffffff);
  files.push_back(drive()
                      .fixed(kAtTheMiddle)
                      .message("/scan", "sensor_msgs/LaserScan", scan.bytes(), {1})
                      .bytes());
  files.push_back(Mcap()
                      .message("/tf", "tf2_msgs/TFMessage",
                               Packed().add<std::uint32_t>(0xffffffff).bytes(), {1})
                      .bytes());
  for (const std::string& bytes : files) {
    const auto r = read(bytes);
    EXPECT_TRUE(!r.error.empty() || r.counts.lines_malformed > 0);
  }
  EXPECT_LT(peak_kb() - before, 50'000);
}

TEST_F(RosDamage, MessagesThatCannotBeReadAreCounted) {
  Mcap file = drive().fixed(kAtTheMiddle);
  file.message("/scan", "sensor_msgs/LaserScan", "short", {1004, 0});
  file.message("/scan", "sensor_msgs/LaserScan", recording::Scan().bytes() + "long", {1005, 0});
  const auto r = read(file);
  EXPECT_EQ(r.steps.size(), 4U);
  EXPECT_EQ(r.counts.lines_malformed, 2U);
  EXPECT_TRUE(r.warns("/scan: the message ends early (first message that cannot be read)"));
}

TEST_F(RosDamage, OldAndEncryptedBagsAreTold) {
  writeWhole(folder / "a.bag", "#ROSBAG V1.2\nabc");
  expectTold(sample::read(folder / "a.bag"), {"version before 2.0", "rosbag fix"});
  std::string bytes = readWhole(kRecordings / "odom.bag");
  const std::size_t at = bytes.find("conn_count=");
  bytes.replace(at, 15, "encryptor=abcde");
  writeWhole(folder / "a.bag", bytes);
  expectTold(sample::read(folder / "a.bag"), {"encrypted (abcde)"});
}

TEST_F(RosDamage, OtherDatabasesAreTold) {
  std::string bytes = readWhole(kRecordings / "tf.db3");
  for (std::size_t at = 0; (at = bytes.find("messages", at)) != bytes.npos;)
    bytes.replace(at, 8, "massages");
  writeWhole(folder / "a.db3", bytes);
  expectTold(sample::read(folder / "a.db3"), {"without a table 'messages'"});
}

TEST_F(RosDamage, ADamagedDatabaseGivesWhatIsBefore) {
  std::string bytes = readWhole(kRecordings / "tf.db3");
  bytes.resize(bytes.size() * 3 / 4);
  writeWhole(folder / "a.db3", bytes);
  const auto r = sample::read(folder / "a.db3");
  EXPECT_TRUE(r.steps.empty() ? !r.error.empty() : r.warns("what follows is lost"));
}

TEST_F(RosDamage, LookingThroughCanBeStopped) {
  writeWhole(folder / "a.mcap", whole());
  ariadne::io::DatasetOptions options;
  // Called once in 256 messages.
  Mcap file = drive().fixed(kAtTheMiddle);
  for (std::uint32_t i = 0; i < 600; ++i) file.odom({1004, i}, {});
  writeWhole(folder / "b.mcap", file.bytes());
  options.goes_on = [](double share) {
    EXPECT_GT(share, 0);
    EXPECT_LE(share, 1);
    return false;
  };
  EXPECT_THROW(ariadne::io::openDataset(folder / "b.mcap", options), ariadne::core::Error);
}
