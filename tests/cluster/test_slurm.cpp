// The batch script and what may be said about it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "../io/temporary_folder.h"
#include "ariadne/cluster/slurm_script.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(SlurmScript, SaysWhatWasAskedFor) {
  const cluster::WorkerCall worker{"/opt/bin/ariadne-experiment", "/shared/x", 40, 2, 3};
  cluster::SlurmOptions options;
  options.partition = "short";
  options.time = "2:00:00";
  options.memory = "4G";
  options.array_limit = 7;
  options.more = {"--account=lab"};
  const std::string text = slurmScript(worker, options, "ariadne-1", "/shared/x/jobs/1", {1, 2, 5});
  EXPECT_EQ(text.substr(0, 10), "#!/bin/sh\n");
  for (const char* line :
       {"#SBATCH --job-name=ariadne-1\n", "#SBATCH --array=1-2,5%7\n",
        "#SBATCH --partition=short\n", "#SBATCH --time=2:00:00\n", "#SBATCH --mem=4G\n",
        "--cpus-per-task=6\n", "--requeue", "#SBATCH --account=lab\n",
        "#SBATCH --output=\"/shared/x/jobs/1/slice-%a.log\"\n",
        "--slice \"$SLURM_ARRAY_TASK_ID/40\" --jobs 2\n"})
    EXPECT_TRUE(has(text, line)) << line << "\n" << text;
  const std::string plain = slurmScript(worker, {}, "ariadne-1", "/x", {1});
  for (const char* option : {"--partition", "--time", "--mem", "%0"})
    EXPECT_FALSE(has(plain, option)) << option;
}

class SlurmScriptRun : public TemporaryFolder {};

TEST_F(SlurmScriptRun, NamesThatShellsGetWrongComeThrough) {
  const fs::path odd = folder / "it's 100% $HOME `x`";
  fs::create_directories(odd);
  io::writeWhole(odd / "program",
                 std::string_view("#!/bin/sh\nfor w in \"$@\"; do echo \"[$w]\"; done\n"));
  fs::permissions(odd / "program", fs::perms::owner_all);
  const std::string text = cluster::slurmScript({odd / "program", odd, 3, 1, 1}, {}, "n", odd, {2});
  EXPECT_TRUE(has(text, "it's 100%% $HOME `x`/slice-%a.log\"")) << text;
  io::writeWhole(folder / "script", text);
  const std::vector<std::string> command{"env", "SLURM_ARRAY_TASK_ID=2", "sh",
                                         (folder / "script").string()};
  auto ran = process::call(command);
  EXPECT_FALSE(ran.ok);
  EXPECT_TRUE(has(ran.error, "does not see")) << ran.error;
  io::writeWhole(odd / "plan.json", std::string_view("{}"));
  ran = process::call(command);
  EXPECT_TRUE(ran.ok) << ran.error;
  EXPECT_TRUE(has(ran.out, "[work]\n[" + odd.string() + "]\n[--slice]\n[2/3]\n[--jobs]\n[1]\n"))
      << ran.out;
  EXPECT_THROW(cluster::slurmScript({odd, odd, 1, 1, 1}, {}, "n", "/a\"b", {1}), core::UsageError);
}

TEST(SlurmOptions, TimesAsSlurmReadsThem) {
  EXPECT_EQ(cluster::slurmTime_s("90"), 5400);
  EXPECT_EQ(cluster::slurmTime_s("90:30"), 5430);
  EXPECT_EQ(cluster::slurmTime_s("1:30:00"), 5400);
  EXPECT_EQ(cluster::slurmTime_s("2-12"), 216000);
  EXPECT_EQ(cluster::slurmTime_s("2-12:30"), 217800);
  EXPECT_EQ(cluster::slurmTime_s("2-12:30:05"), 217805);
  for (const char* text : {"", "1h", "1:2:3:4", "-5", "2-", "1:", "12 "})
    EXPECT_LT(cluster::slurmTime_s(text), 0) << text;
}

TEST(SlurmOptions, WrongOnesAreNamed) {
  const auto problem = [](auto&& change) {
    cluster::SlurmOptions options;
    change(options);
    try {
      cluster::check(options);
    } catch (const core::UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(problem([](auto& o) { o.time = "1:00:00", o.partition = "a,b-2", o.memory = "500M"; }),
            "");
  EXPECT_TRUE(has(problem([](auto& o) { o.time = "1h"; }), "--time 1h: takes"));
  EXPECT_TRUE(has(problem([](auto& o) { o.time = "0"; }), "--time 0: takes"));
  EXPECT_TRUE(has(problem([](auto& o) { o.partition = "a b"; }), "--partition a b: takes"));
  EXPECT_TRUE(has(problem([](auto& o) { o.partition.assign(200000, 'a'); }), "takes the name"));
  EXPECT_TRUE(has(problem([](auto& o) { o.memory.assign(200000, '1'); }), "--mem 1"));
  EXPECT_TRUE(has(problem([](auto& o) { o.memory = "4 G"; }), "--mem 4 G: takes"));
  EXPECT_TRUE(has(problem([](auto& o) { o.more = {"account"}; }), "--sbatch account: takes"));
}
