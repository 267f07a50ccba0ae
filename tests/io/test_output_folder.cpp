#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "ariadne/core/error.h"
#include "ariadne/io/output_folder.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

namespace fs = std::filesystem;
using ariadne::core::Error;
using ariadne::core::UsageError;
using ariadne::io::prepareOutputFolder;

class OutputFolder : public TemporaryFolder {
 protected:
  void put(const fs::path& path) { std::ofstream(path) << "mine"; }
};

TEST_F(OutputFolder, IsMadeWithItsParents) {
  prepareOutputFolder(folder / "a" / "b", {"map.png"}, false);
  EXPECT_TRUE(fs::is_empty(folder / "a" / "b"));
  prepareOutputFolder(folder / "a" / "b", {"map.png"}, false);  // empty: fine
}

TEST_F(OutputFolder, WithFilesNeedsOverwriteAndNothingIsDeleted) {
  put(folder / "map.png");
  put(folder / "notes.txt");
  EXPECT_THROW(prepareOutputFolder(folder, {"map.png"}, false), UsageError);
  prepareOutputFolder(folder, {"map.png"}, true);
  EXPECT_EQ(ariadne::io::readWhole(folder / "map.png"), "mine");
  EXPECT_EQ(ariadne::io::readWhole(folder / "notes.txt"), "mine");
}

TEST_F(OutputFolder, AFileOrAFolderInTheWayIsAnError) {
  put(folder / "file");
  EXPECT_THROW(prepareOutputFolder(folder / "file", {}, true), UsageError);
  EXPECT_THROW(prepareOutputFolder(folder / "file" / "below", {}, true), Error);
  fs::create_directories(folder / "map.png");
  EXPECT_THROW(prepareOutputFolder(folder, {"map.png"}, true), UsageError);
}

TEST_F(OutputFolder, WhereNothingCanBeWrittenIsAnErrorBeforeTheWork) {
  EXPECT_THROW(prepareOutputFolder("/proc/ariadne", {}, false), Error);
  EXPECT_THROW(prepareOutputFolder("/proc/sys", {}, true), Error);
}

// A file size limit stands for a full disk: writes fail after the folder was made.
TEST_F(OutputFolder, AFullDiskIsAnErrorAndLeavesNoFile) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit none{0, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &none);
  EXPECT_THROW(prepareOutputFolder(folder / "out", {}, false), Error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(fs::is_empty(folder / "out"));
}
