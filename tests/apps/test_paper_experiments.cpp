// The experiments of ini/paper on one seed each; whole results are in doc/paper.md.
#include <gtest/gtest.h>

#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "experiment_app.h"

namespace fs = std::filesystem;

namespace {

fs::path paperInis() { return ariadne::test::shippedDatasets().parent_path() / "ini" / "paper"; }

struct Said {
  int code;
  std::string out, err;
};

Said call(const std::vector<std::string>& args) {
  std::ostringstream out;
  std::ostringstream err;
  const int code = ariadne::runExperimentApp(args, out, err);
  return {code, out.str(), err.str()};
}

class PaperExperiments : public TemporaryFolder {
 protected:
  /// The CSV table of the shipped experiment on one seed.
  std::string tableOf(const std::string& name, const std::string& seed) {
    const std::string results = (folder / name).string();
    const Said run = call({"run", (paperInis() / (name + ".ini")).string(), "--out", results,
                           "--first", seed, "--last", seed, "--quiet"});
    EXPECT_EQ(run.code, 0) << run.err;
    return call({"table", results, "--format", "csv"}).out;
  }
};

}  // namespace

TEST_F(PaperExperiments, AllCanBePlanned) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(paperInis())) {
    SCOPED_TRACE(entry.path().string());
    ++count;
    const Said said = call({"run", entry.path().string(), "--dry-run"});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find(" 0 finished"), std::string::npos) << said.out;
  }
  EXPECT_EQ(count, 8U);
}

// Fig. 6 on one seed. Of seeds 2001 to 2020 all cover over 99 % and 19 are correct; 2001 was
// correct in every build tried.
TEST_F(PaperExperiments, ThreeLoopsAreExploredAndClosed) {
  const std::string table = tableOf("three_loops", "2001");
  EXPECT_NE(table.find("active_neff_recovery,1,0,1,"), std::string::npos) << table;
}

// One pair of sixty: with recovery 54 are right, without 18.
TEST_F(PaperExperiments, TheNestedLoopIsClosedWithRecovery) {
  const std::string table = tableOf("nested_loop", "1001");
  EXPECT_NE(table.find("recovery,1,0,1,"), std::string::npos) << table;
}
