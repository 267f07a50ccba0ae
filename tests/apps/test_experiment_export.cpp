// ariadne-experiment export, and run --where.
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <sstream>

#include "../batch/stand_in.h"
#include "ariadne/process/find_program.h"
#include "experiment_app.h"

namespace fs = std::filesystem;

namespace {

class ExperimentExport : public StandIn {
 protected:
  int run(const std::vector<std::string>& args) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    const int code = ariadne::runExperimentApp(args, out_stream, err_stream);
    said = out_stream.str() + err_stream.str();
    return code;
  }
  std::string at(const std::string& name) const { return (folder / name).string(); }
  /// What is exported of the experiment done with so many jobs: text by file.
  std::map<std::string, std::string> exported(const std::string& jobs) {
    const std::string name = "jobs" + jobs;
    EXPECT_EQ(run({"run", ini().string(), "--out", at(name), "--jobs", jobs}), 0) << said;
    EXPECT_EQ(run({"export", at(name), at("of-" + name)}), 0) << said;
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(at("of-" + name)))
      if (entry.is_regular_file())
        files[entry.path().lexically_relative(at("of-" + name)).string()] =
            ariadne::io::readWhole(entry.path());
    return files;
  }
  std::string said;
};

}  // namespace

TEST_F(ExperimentExport, IsTheSameBytesOnAnyNumberOfJobsWithoutPathsAndHosts) {
  writeExperiment("relative = value\n[seeds]\nlast = 6\n[factor.p]\nkey = a.p\nvalues = 1, 2\n");
  const auto one = exported("1");
  EXPECT_EQ(one, exported("3"));
  for (const char* file : {"table.txt", "table.csv", "table.md", "table.tex", "runs.csv"})
    EXPECT_EQ(one.count(file), 1U) << file;
  EXPECT_EQ(one.size(), ariadne::process::findInPath("gnuplot").empty() ? 5U : 7U);
  const auto& runs = one.at("runs.csv");
  EXPECT_EQ(runs.substr(0, runs.find("\n2,")),
            "seed,p,arm,failed,success,value\n1,1,first,0,1,2\n1,1,second,0,1,3\n"
            "1,2,first,0,1,2\n1,2,second,0,1,3");
  char host[256] = {};
  ::gethostname(host, sizeof(host) - 1);
  for (const auto& [file, text] : one) {
    EXPECT_EQ(text.find(folder.string()), std::string::npos) << file;
    EXPECT_EQ(text.find(host), std::string::npos) << file;
  }
}

TEST_F(ExperimentExport, OfAFolderThatIsNone) {
  EXPECT_EQ(run({"export", at("none"), at("x")}), 2);
  EXPECT_NE(said.find("no results folder"), std::string::npos) << said;
  EXPECT_EQ(run({"export", at("none")}), 2);
  EXPECT_NE(said.find("TO"), std::string::npos) << said;
  EXPECT_FALSE(fs::exists(at("x")));
}

TEST_F(ExperimentExport, WhereTakesAPartOfAFactor) {
  writeExperiment("[seeds]\nlast = 2\n[factor.p]\nkey = a.p\nvalues = 1, 2, 3\n");
  ASSERT_EQ(run({"run", ini().string(), "--dry-run", "--where", "p=3,1"}), 0) << said;
  EXPECT_NE(said.find("Test: 8 runs"), std::string::npos) << said;
  EXPECT_EQ(said.find("p 2"), std::string::npos) << said;
  const auto wrong = [&](const std::string& where) {
    EXPECT_EQ(run({"run", ini().string(), "--dry-run", "--where", where}), 2) << said;
    return said;
  };
  EXPECT_NE(wrong("p=4").find("4 is none of the values 1, 2, 3"), std::string::npos) << said;
  EXPECT_NE(wrong("p").find("as p=1"), std::string::npos) << said;
  EXPECT_NE(wrong("laps=3").find("no such factor, but p"), std::string::npos) << said;
}
