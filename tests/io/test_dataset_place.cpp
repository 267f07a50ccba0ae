#include <cstdlib>

#include "ariadne/io/dataset_place.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

using namespace ariadne;
namespace fs = std::filesystem;

class DatasetPlace : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    if (const char* was = std::getenv("ARIADNE_DATASETS")) before = was;
    ::unsetenv("ARIADNE_DATASETS");
    inis = folder / "project" / "ini";
    fs::create_directories(inis);
  }
  void TearDown() override {
    if (!before.empty()) ::setenv("ARIADNE_DATASETS", before.c_str(), 1);
    TemporaryFolder::TearDown();
  }
  static fs::path made(const fs::path& file) {
    fs::create_directories(file.parent_path());
    io::writeWhole(file, std::string_view("x"));
    return file;
  }
  std::string before;
  fs::path inis;
};

TEST_F(DatasetPlace, HereThenWhereTheEnvironmentSaysElseBesideTheProject) {
  const fs::path beside = folder / "shared" / "datasets";
  EXPECT_EQ(io::datasetPlace("a/b.log", inis), inis / "a/b.log") << "nowhere: for the error";
  const fs::path shared = made(beside / "a/b.log");
  EXPECT_EQ(io::datasetPlace("a/b.log", inis), shared);
  ::setenv("ARIADNE_DATASETS", (folder / "given").c_str(), 1);
  EXPECT_EQ(io::datasetPlace("a/b.log", inis), inis / "a/b.log") << "only where it says";
  const fs::path given = made(folder / "given" / "a/b.log");
  EXPECT_EQ(io::datasetPlace("a/b.log", inis), given);
  const fs::path here = made(inis / "a/b.log");
  EXPECT_EQ(io::datasetPlace("a/b.log", inis), here);
  ::unsetenv("ARIADNE_DATASETS");
}

TEST_F(DatasetPlace, OfAnIniThatIsNamedFromItsOwnFolder) {
  const fs::path shared = made(folder / "shared" / "datasets" / "a/b.log");
  const fs::path before_this = fs::current_path();
  fs::current_path(inis);
  EXPECT_EQ(io::datasetPlace("a/b.log", ""), shared);
  EXPECT_EQ(io::datasetPlace("none.log", ""), "none.log");
  fs::current_path(before_this);
}
