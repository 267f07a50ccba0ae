// Programs as children: what they cost, how they end, what they say.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"
#include "ariadne/process/find_program.h"
#include "ariadne/process/share_read.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

class Processes : public TemporaryFolder {};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(Processes, IsMeasuredByItself) {
  // A shell that keeps one core busy for a while; its memory is not that of this process.
  const auto costs = process::runToEnd(
      {"/bin/sh", "-c", "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"}, folder / "log");
  EXPECT_GT(costs.cpu_s, 0.01);
  EXPECT_LE(costs.cpu_s, costs.wall_s + 0.1);
  EXPECT_GT(costs.memory_mb, 0.5);
  const auto ours = process::runToEnd({"/bin/cat", "/proc/self/status"}, folder / "status");
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(ours.memory_mb, 30) << "2.3 measured; this process, with our libraries, has over 70";
#endif
}

TEST_F(Processes, TellsHowItEnded) {
  const auto said = [&](const std::vector<std::string>& command) -> std::string {
    try {
      process::runToEnd(command, folder / "log");
    } catch (const core::Error& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(said({"/bin/sh", "-c", "echo first; echo 'last words' >&2; exit 3"})
                .find("exit code 3: last words"),
            std::string::npos);
  EXPECT_NE(said({"/bin/sh", "-c", "kill -9 $$"}).find("killed by signal 9"), std::string::npos);
  EXPECT_NE(said({(folder / "none").string()}).find("No such file"), std::string::npos);
  EXPECT_TRUE(process::findSister("ariadne-no-such-program").empty());
}

TEST_F(Processes, TellsHowFarOneIsInAFile) {
  io::writeWhole(folder / "log", std::string(4000, 'x'));
  const std::string file = (folder / "log").string();
  // Reads a quarter and keeps the file open.
  process::Process reader(
      {"/bin/sh", "-c", "exec 3<\"$0\"; dd bs=1000 count=1 <&3 >&2; sleep 60", file}, {});
  std::optional<double> share;
  while (reader.elapsed_s() < 10 && share.value_or(0) == 0) {
    share = process::shareRead(reader.pid(), file);
    process::waitForAny({&reader}, std::chrono::milliseconds(10));
  }
  EXPECT_EQ(share, 0.25);
  EXPECT_FALSE(process::shareRead(reader.pid(), folder / "other"));
  EXPECT_FALSE(process::shareRead(-1, file));
}

TEST(Called, TellsWhatIsMissingFailsOrHangs) {
  EXPECT_TRUE(process::call({"no-such-program-here"}).missing);
  const auto failed = process::call({"sh", "-c", "echo a; echo b >&2; exit 3"});
  EXPECT_FALSE(failed.ok);
  EXPECT_EQ(failed.out, "a\n");
  EXPECT_EQ(failed.error, "b");
  EXPECT_EQ(process::call({"sh", "-c", "exit 3"}).error, "exit code 3");
  EXPECT_TRUE(has(process::call({"sleep", "100"}, 0.2).error, "no answer"));
}

TEST_F(Processes, WhatACalledProgramPrintsLiesWhereOthersCannotPutALink) {
  fs::create_directories(folder / "tmp");
  io::writeWhole(folder / "victim", std::string_view("precious"));
  fs::create_symlink(folder / "victim",
                     folder / "tmp" / ("ariadne-called-" + std::to_string(::getpid())));
  ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
  const auto called = process::call({"sh", "-c", "echo a"});
  ::unsetenv("TMPDIR");
  EXPECT_EQ(called.out, "a\n");
  EXPECT_EQ(io::readWhole(folder / "victim"), "precious");
}
