#include <gtest/gtest.h>

#include "ariadne/io/log_or_ini.h"
#include "ariadne/io/whole_file.h"
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace ariadne;
using namespace std::string_literals;

class LogOrIni : public TemporaryFolder {
 protected:
  bool isLog(const std::string& name, const std::string& content) {
    io::writeWhole(folder / name, content);
    return io::looksLikeLog(folder / name);
  }
};

TEST_F(LogOrIni, TextsAreToldByTheirFirstLine) {
  EXPECT_TRUE(isLog("a.log", sample::carmenLog(3)));
  EXPECT_TRUE(isLog("a", "# comment [section]\n\nPARAM robot_width = 0.5\n"));
  EXPECT_FALSE(isLog("a.conf", "# comment\n\n  [grid]\nresolution_m = 0.1\n"));
  EXPECT_FALSE(isLog("a.txt", "// of MRPT\r\nkey=1\r\n"));
  EXPECT_FALSE(isLog("a.txt", "\xEF\xBB\xBF[grid]\r\n"));
  EXPECT_FALSE(isLog("a.txt", "; nothing but this"));
  EXPECT_FALSE(isLog("a.txt", ""));
}

TEST_F(LogOrIni, WhatIsNoTextIsALog) {
  EXPECT_TRUE(isLog("a.bag", "#ROSBAG V2.0\nE\x04\0\0"s + "\x01"));
  EXPECT_TRUE(isLog("a.rawlog", std::string("\x12\0CAction", 9)));
}

TEST_F(LogOrIni, FoldersAreRecordingsAndIniIsAnIniWhateverIsInIt) {
  EXPECT_TRUE(io::looksLikeLog(folder));
  EXPECT_FALSE(isLog("a.ini", sample::carmenLog(3)));
  EXPECT_FALSE(isLog("b.INI", "FLASER"));
  EXPECT_FALSE(io::looksLikeLog(folder / "missing.log"));
  EXPECT_FALSE(io::looksLikeLog("/dev/null"));
}
