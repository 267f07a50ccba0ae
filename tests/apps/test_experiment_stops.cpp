// ariadne-experiment as a process that is stopped: kill -9 at any moment, Ctrl-C, two at once.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "../batch/stand_in.h"

namespace fs = std::filesystem;
using std::chrono::milliseconds;

namespace {

/// A zombie that nobody has waited for yet is dead.
bool isAlive(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  return !text.empty() && text.substr(text.rfind(')') + 2, 1) != "Z";
}

class ExperimentStops : public StandIn {
 protected:
  /// Starts ariadne-experiment; what it prints is in the file NAME.out.
  pid_t start(std::vector<std::string> args, const std::string& name = "x") {
    args.insert(args.begin(), fs::path(std::getenv("ARIADNE_BIN_DIR")) / "ariadne-experiment");
    std::vector<char*> argv;
    for (std::string& a : args) argv.push_back(a.data());
    argv.push_back(nullptr);
    const std::string out = (folder / (name + ".out")).string();
    const std::string err = (folder / (name + ".err")).string();
    const pid_t pid = ::fork();
    if (pid == 0) {
      if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen(err.c_str(), "w", stderr))
        ::_exit(99);
      ::execv(argv[0], argv.data());
      ::_exit(98);
    }
    return pid;
  }
  /// Its exit code, or 1000 and the signal.
  static int wait(pid_t pid) {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  int runTo(const std::string& name, const std::string& jobs) {
    return wait(
        start({"run", ini().string(), "--out", (folder / name).string(), "--jobs", jobs}, name));
  }
  std::string printed(const std::string& name) const {
    return ariadne::io::readWhole(folder / (name + ".out"));
  }
  /// All results by name of their file.
  std::map<std::string, std::string> stored(const std::string& name) const {
    std::map<std::string, std::string> all;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder / name / "runs", ignored))
      if (entry.path().filename().string()[0] != '.')
        all[entry.path().filename().string()] = ariadne::io::readWhole(entry.path());
    return all;
  }
};

}  // namespace

TEST_F(ExperimentStops, KilledAtTwentyMomentsItComesToTheSameBytes) {
  writeProgram("sleep 0.03");
  writeExperiment("[seeds]\nlast = 80\n");
  const auto start_of_whole = std::chrono::steady_clock::now();
  ASSERT_EQ(runTo("whole", "4"), 0);
  const auto whole = std::chrono::steady_clock::now() - start_of_whole;
  std::mt19937 random(1);
  // On an idle machine the whole takes 1.4 s; on a busy one starting alone can take 0.4 s.
  const long longest_ms = std::chrono::duration_cast<milliseconds>(whole).count() * 3 / 10;
  std::uniform_int_distribution<long> moment_ms(0, std::max(400L, longest_ms));
  std::map<std::string, std::string> before;
  std::set<std::size_t> counts;
  for (int kill = 0; kill < 20; ++kill) {
    const pid_t pid = start({"run", ini().string(), "--out", results().string(), "--jobs", "2"});
    std::this_thread::sleep_for(milliseconds(moment_ms(random)));
    ::kill(pid, SIGKILL);
    wait(pid);
    const auto now = stored("results");
    for (const auto& [file, text] : before) {
      ASSERT_EQ(now.count(file), 1U) << "lost";
      ASSERT_EQ(now.at(file), text) << "done twice";
    }
    before = now;
    counts.insert(now.size());
  }
  // 6 were seen on a machine with three builds beside it.
  EXPECT_GT(counts.size(), 3U) << "no kill came while runs were done";
  ASSERT_EQ(runTo("results", "4"), 0);
  const auto end = stored("results");
  EXPECT_EQ(end.size(), 160U);
  for (const auto& [file, text] : before) EXPECT_EQ(end.at(file), text);
  EXPECT_EQ(printed("results"), printed("whole"));
  EXPECT_NE(printed("whole").find("second  80"), std::string::npos) << printed("whole");
  EXPECT_TRUE(fs::is_empty(results() / "claims" / "owners"));
  EXPECT_FALSE(fs::exists(results() / "scratch"));
  RecordProperty("finished_at_last_kill", static_cast<int>(before.size()));
}

TEST_F(ExperimentStops, CtrlCEndsTheRunsAndKeepsWhatIsDone) {
  writeProgram("[ $seed -gt 2 ] && { echo $$ >> \"$here/pids\"; exec sleep 100; }");
  writeExperiment("[seeds]\nlast = 9\n");
  const pid_t pid = start({"run", ini().string(), "--out", results().string(), "--jobs", "2"});
  for (int i = 0; i < 500 && !fs::exists(folder / "pids"); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  std::this_thread::sleep_for(milliseconds(50));
  ::kill(pid, SIGINT);
  EXPECT_EQ(wait(pid), 130);
  EXPECT_EQ(stored("results").size(), 4U);
  const std::string err = ariadne::io::readWhole(folder / "x.err");
  EXPECT_NE(err.find("the same command goes on"), std::string::npos) << err;
  std::istringstream pids(ariadne::io::readWhole(folder / "pids"));
  for (pid_t child = 0; pids >> child;) EXPECT_FALSE(isAlive(child)) << child << " still runs";
}

TEST_F(ExperimentStops, KilledItTakesItsRunsAlong) {
  writeProgram("echo $$ >> \"$here/pids\"; exec sleep 100");
  const pid_t pid = start({"run", ini().string(), "--out", results().string(), "--jobs", "2"});
  for (int i = 0; i < 500 && !fs::exists(folder / "pids"); ++i)
    std::this_thread::sleep_for(milliseconds(10));
  ::kill(pid, SIGKILL);
  wait(pid);
  std::this_thread::sleep_for(milliseconds(100));
  std::istringstream pids(ariadne::io::readWhole(folder / "pids"));
  for (pid_t child = 0; pids >> child;) EXPECT_FALSE(isAlive(child)) << child << " still runs";
}

TEST_F(ExperimentStops, ThreeAtOnceDoEachRunOnce) {
  writeProgram("echo $seed $arm >> \"$here/log\"; sleep 0.02");
  writeExperiment("[seeds]\nlast = 20\n");
  std::vector<pid_t> pids;
  for (const char* name : {"results", "r2", "r3"})
    pids.push_back(
        start({"run", ini().string(), "--out", results().string(), "--jobs", "2"}, name));
  for (const pid_t pid : pids) EXPECT_EQ(wait(pid), 0);
  std::multiset<std::string> lines;
  std::istringstream log(ariadne::io::readWhole(folder / "log"));
  for (std::string line; std::getline(log, line);) lines.insert(line);
  EXPECT_EQ(lines.size(), 40U);
  EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), 40U);
  EXPECT_EQ(printed("results"), printed("r2"));
  EXPECT_EQ(printed("results"), printed("r3"));
}
