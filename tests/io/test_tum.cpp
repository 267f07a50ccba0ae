#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

using ariadne::core::Error;
using ariadne::io::readTum;
using ariadne::io::writeTum;
using ariadne::io::writeWhole;

class Tum : public TemporaryFolder {
 protected:
  std::string complaint(const std::string& content) {
    writeWhole(folder / "t.tum", content);
    try {
      readTum(folder / "t.tum");
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  }
};

TEST_F(Tum, ReadsBackWhatWasWritten) {
  ariadne::geometry::Trajectory path;
  for (int i = 0; i < 50; ++i)
    path.push_back({1134863809.123457 + 0.213 * i, {0.1 * i, -0.02 * i * i, std::sin(0.3 * i)}});
  writeTum(folder / "t.tum", path, {"map_from_robot", "second line"});
  const auto back = readTum(folder / "t.tum");
  ASSERT_EQ(back.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(back[i].time_s, path[i].time_s);
    EXPECT_NEAR(back[i].pose.x, path[i].pose.x, 1e-9);
    EXPECT_NEAR(back[i].pose.y, path[i].pose.y, 1e-9);
    EXPECT_NEAR(back[i].pose.phi, path[i].pose.phi, 1e-11);
  }
  EXPECT_EQ(ariadne::io::readWhole(folder / "t.tum").rfind("# map_from_robot\n# second line\n", 0),
            0U);
}

TEST_F(Tum, SortsByTimeAndKeepsTheOrderOfEqualStamps) {
  writeWhole(folder / "t.tum", "# c\n\n2 1 0 0 0 0 0 1\r\n1 2 0 0 0 0 0 2\n2 3 0 0 0 0 0 -1");
  const auto path = readTum(folder / "t.tum");
  ASSERT_EQ(path.size(), 3U);
  EXPECT_EQ(path[0].pose.x, 2);
  EXPECT_EQ(path[1].pose.x, 1);
  EXPECT_EQ(path[2].pose.x, 3);
  for (const auto& p : path) EXPECT_NEAR(p.pose.phi, 0, 1e-12);
}

TEST_F(Tum, NamesFileAndLine) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  for (const char* bad :
       {"1 2 3", "1 0 0 0 0 0 0 1 5", "x 0 0 0 0 0 0 1", "1 nan 0 0 0 0 0 1", "1 0 0 0 0 0 0 0",
        "1 0 inf 0 0 0 0 1", "1403636579763555584 0 0 0 0 0 0 1", "1 1e300 0 0 0 0 0 1"})
    EXPECT_NE(complaint(good + bad).find("t.tum:2: "), std::string::npos) << bad;
  EXPECT_NE(complaint("").find("t.tum: no pose"), std::string::npos);
  EXPECT_NE(complaint("# only\n").find("t.tum: no pose"), std::string::npos);
  EXPECT_THROW(readTum(folder / "missing.tum"), Error);
}

TEST_F(Tum, MutatedFilesGiveAResultOrAnError) {
  std::string base;
  for (int i = 0; i < 20; ++i) base += std::to_string(i) + ".5 1.25 -3e-2 0 0 0 0.6 0.8\n";
  for (std::uint32_t round = 0; round < 500; ++round) {
    ariadne::core::RandomStream random(11, round, 0, ariadne::core::Purpose::test);
    std::string mutant = base;
    for (int k = 0; k < 3; ++k) mutant[random.bits() % mutant.size()] = char(random.bits());
    mutant.resize(mutant.size() - random.bits() % 20);
    complaint(mutant);
  }
}
