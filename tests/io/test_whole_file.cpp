#include <gtest/gtest.h>
#include <unistd.h>

#include <stdexcept>

#include "ariadne/core/error.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;
using ariadne::io::writeWhole;

class WholeFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("ariadne-whole-file-" + std::to_string(::getpid()));
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::size_t files() const { return std::distance(fs::directory_iterator(folder), {}); }
  fs::path folder;
};

TEST_F(WholeFile, ReadsBackWhatWasWritten) {
  const std::string content(200000, 'x');
  writeWhole(folder / "a.txt", content);
  EXPECT_EQ(readWhole(folder / "a.txt"), content);
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFile, AFailingWriterLeavesTheOldFile) {
  writeWhole(folder / "a.txt", "old");
  EXPECT_THROW(writeWhole(folder / "a.txt",
                          [](const fs::path& p) {
                            writeWhole(p, "half");
                            throw std::runtime_error("stop");
                          }),
               std::runtime_error);
  EXPECT_EQ(readWhole(folder / "a.txt"), "old");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WholeFile, RefusesWhatIsNoFile) {
  fs::create_directory(folder / "sub");
  EXPECT_THROW(writeWhole(folder / "sub", "x"), ariadne::core::Error);
  fs::create_symlink("/dev/null", folder / "null");
  EXPECT_THROW(writeWhole(folder / "null", "x"), ariadne::core::Error);
  EXPECT_TRUE(fs::is_symlink(folder / "null"));
}

TEST_F(WholeFile, WhatOthersPutWhereItWritesIsNotFollowed) {
  writeWhole(folder / "victim", "precious");
  const fs::path half = folder / (".a." + ariadne::io::writerMark() + ".part.txt");
  fs::create_symlink(folder / "victim", half);
  EXPECT_THROW(writeWhole(folder / "a.txt", "x"), ariadne::core::Error);
  EXPECT_EQ(readWhole(folder / "victim"), "precious");
  EXPECT_TRUE(fs::is_symlink(half)) << "it is not ours to remove";
}

TEST_F(WholeFile, ScratchFoldersAreOfOneUserAndGoAway) {
  fs::path first;
  {
    const ariadne::io::ScratchFolder a("test"), b("test");
    first = a.path();
    EXPECT_NE(a.path(), b.path());
    EXPECT_EQ(fs::status(first).permissions(), fs::perms::owner_all);
    writeWhole(first / "x", "y");
  }
  EXPECT_FALSE(fs::exists(first));
}

TEST_F(WholeFile, NamesAPathThatCannotBeWritten) {
  try {
    writeWhole(folder / "missing" / "a.txt", "x");
    FAIL();
  } catch (const ariadne::core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("missing/a.txt"), std::string::npos) << e.what();
  }
  EXPECT_THROW(readWhole(folder / "none"), ariadne::core::Error);
  EXPECT_THROW(readWhole(folder), ariadne::core::Error);
}
