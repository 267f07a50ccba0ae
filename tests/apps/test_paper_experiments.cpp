// The experiments of ini/paper and of ini/regression (the committed drives, MRPT's sample log) on
// one seed each, next to the committed results of whole runs (doc/lab/experiments/results, made by
// scripts/paper-results).
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "../io/temporary_folder.h"
#include "../shipped_datasets.h"
#include "ariadne/io/dataset_place.h"
#include "committed_results.h"
#include "experiment_app.h"

namespace fs = std::filesystem;

namespace {

const fs::path kProject = ariadne::test::shippedDatasets().parent_path();
const fs::path kResults = kProject / "doc/lab/experiments/results";

fs::path iniOf(const std::string& name) {
  return kProject / "ini" / (name == "datasets" ? "regression" : "paper") / (name + ".ini");
}

/// The logs of these two are not part of the project.
bool isHere(const std::string& name) {
  if (name == "datasets")
    return fs::exists(
        "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");
  return name != "killian_court" || fs::exists(ariadne::io::datasetPlace(
                                        "infinite-corridor/infinite-corridor-corrected.log.gz",
                                        kProject / "ini/paper/drives"));
}

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

/// A run of one seed; ctest runs each in a process of its own.
struct Small {
  std::string name;
  std::string seed;
  std::vector<std::string> where;  ///< a part of what takes long
};

void PrintTo(const Small& small, std::ostream* out) { *out << small.name; }

class PaperExperiments : public TemporaryFolder, public ::testing::WithParamInterface<Small> {
 protected:
  std::string at(const std::string& name) const { return (folder / name).string(); }
};

}  // namespace

TEST_P(PaperExperiments, ASeedIsWithinTheCommittedResults) {
  const Small& small = GetParam();
  if (!isHere(small.name)) GTEST_SKIP() << "its log is missing (README.md, \"Logs\")";
  std::vector<std::string> args = {"run",     iniOf(small.name).string(),
                                   "--out",   at("r"),
                                   "--first", small.seed,
                                   "--last",  small.seed,
                                   "--quiet", "--jobs",
                                   "1"};
  for (const std::string& where : small.where) args.insert(args.end(), {"--where", where});
  const Said run = call(args);
  ASSERT_EQ(run.code, 0) << run.err;
  ASSERT_EQ(call({"export", at("r"), at("x")}).code, 0);
  const auto runs = ariadne::test::readRuns(folder / "x" / "runs.csv");
  EXPECT_FALSE(runs.rows.empty());
  ariadne::test::expectWithin(runs, ariadne::test::readRuns(kResults / small.name / "runs.csv"));
}

INSTANTIATE_TEST_SUITE_P(
    Each, PaperExperiments,
    ::testing::Values(
        Small{"nested_loop", "1001", {}}, Small{"nested_loop_closed", "4001", {"world=nested"}},
        Small{"other_environment", "1001", {}}, Small{"killian_court", "1001", {}},
        Small{"survivors", "1001", {"world=nested2"}}, Small{"neff", "1001", {"world=nested"}},
        Small{"three_loops", "2001", {}}, Small{"path_overhead", "2001", {"world=eight,small"}},
        Small{"against_uncertainty", "2001", {"world=nested"}},
        Small{"strategies", "2001", {"world=office"}},
        Small{"better_maps", "3001", {"world=small"}},
        Small{"new_ground", "2001", {"world=nested2", "strategy=frontier"}},
        Small{"recovery_cost", "1001", {}}, Small{"laps", "1001", {"laps=0,3"}},
        Small{"particles", "1001", {"particles=15"}}, Small{"odometry_noise", "1001", {"noise=2"}},
        Small{"oracle", "1001", {}}, Small{"datasets", "1", {}}),
    [](const auto& small) { return small.param.name; });

TEST(PaperInis, AllCanBePlannedAndHaveCommittedResults) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(kProject / "ini" / "paper")) {
    SCOPED_TRACE(entry.path().string());
    if (entry.is_directory()) continue;  // the drives
    ++count;
    const std::string name = entry.path().stem().string();
    const Said said = call({"run", entry.path().string(), "--dry-run"});
    EXPECT_EQ(said.code, isHere(name) ? 0 : 2) << said.err;
    if (isHere(name)) {
      EXPECT_NE(said.out.find(" 0 finished"), std::string::npos) << said.out;
    }
    if (name == "small") continue;
    for (const char* file : {"table.txt", "table.csv", "table.md", "table.tex", "runs.csv"})
      EXPECT_TRUE(fs::exists(kResults / name / file)) << file;
  }
  EXPECT_EQ(count, 18U);
}

TEST(PaperInis, AMissingLogFailsThePlanAndIsNamed) {
  const char* was = std::getenv("ARIADNE_DATASETS");
  const std::string before = was ? was : "";
  ::setenv("ARIADNE_DATASETS", "/nowhere", 1);
  const Said said = call({"run", iniOf("killian_court").string(), "--dry-run"});
  if (was)
    ::setenv("ARIADNE_DATASETS", before.c_str(), 1);
  else
    ::unsetenv("ARIADNE_DATASETS");
  EXPECT_EQ(said.code, 2);
  for (const char* part :
       {"killian_court.ini:", "infinite-corridor-corrected.log.gz", "there is no such file",
        "slamevaluation/datasets.php", "ARIADNE_DATASETS"})
    EXPECT_NE(said.err.find(part), std::string::npos) << part << "\n" << said.err;
}
