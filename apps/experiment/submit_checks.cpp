#include "submit_checks.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>
#include <tuple>
#include <vector>

#include "ariadne/batch/store.h"
#include "ariadne/cluster/slurm_script.h"
#include "ariadne/core/error.h"
#include "ariadne/process/call.h"
#include "ariadne/process/find_program.h"

namespace ariadne::experiment_app {
namespace {

/// An option that the engine asked for would never look at.
void refuseOthers(const Options& o) {
  const bool slurm = o.engine == Engine::slurm;
  for (const auto& [given, option, is_slurms] : std::vector<std::tuple<bool, const char*, bool>>{
           {!o.slurm.partition.empty(), "--partition", true},
           {!o.slurm.time.empty(), "--time", true},
           {!o.slurm.memory.empty(), "--mem", true},
           {o.slurm.array_limit > 0, "--array-limit", true},
           {!o.slurm.more.empty(), "--sbatch", true},
           {o.script_only, "--script-only", true},
           {!o.parallel.sshloginfile.empty(), "--sshloginfile", false},
           {o.parallel.host_limit > 0, "--host-limit", false}})
    if (given && is_slurms != slurm)
      throw core::UsageError(fmt::format("{} goes with --engine {} (see submit --help)", option,
                                         is_slurms ? "slurm" : "parallel"));
}

}  // namespace

void checkSubmit(const Options& o) {
  refuseOthers(o);
  if (o.engine == Engine::slurm) {
    cluster::check(o.slurm);
    cluster::sbatchName(batch::Store(o.folder).folder());
    if (!o.script_only && process::findInPath("sbatch").empty())
      throw core::UsageError(
          "there is no sbatch in PATH: install Debian's package slurm-client and the cluster's "
          "slurm.conf, or write the script here with --script-only and hand it over elsewhere");
    return;
  }
  std::error_code ignored;
  if (o.parallel.sshloginfile.empty())
    throw core::UsageError(
        "--engine parallel needs --sshloginfile: a file with a machine a line, \":\" for this one");
  if (!std::filesystem::is_regular_file(o.parallel.sshloginfile, ignored))
    throw core::UsageError(
        fmt::format("--sshloginfile: there is no file {}", o.parallel.sshloginfile.string()));
  // moreutils has another program of this name.
  const process::CallResult version = process::call({"parallel", "--version"});
  if (version.missing || version.out.find("GNU parallel") == std::string::npos)
    throw core::UsageError("there is no GNU parallel in PATH: install Debian's package parallel");
}

void warnOfTime(const Options& o, const batch::Plan& plan, std::ostream& err) {
  if (o.slurm.time.empty() || cluster::slurmTime_s(o.slurm.time) >= plan.limits.time_s) return;
  fmt::print(err,
             "ariadne-experiment: a run may take {} s ([limits] time_s), a task ends after --time "
             "{}: a longer run would never come to its end\n",
             plan.limits.time_s, o.slurm.time);
}

}  // namespace ariadne::experiment_app
