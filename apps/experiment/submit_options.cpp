#include "submit_options.h"

#include <map>

#include "named_choice.h"

namespace ariadne::experiment_app {
namespace {

constexpr const char* kSubmitFooter =
    "FOLDER and the programs must lie where all machines see them under the same path.\n"
    "Called again, it hands out what has no result and is in no task that waits or runs in Slurm.\n"
    "More: doc/howto/cluster.md. Examples:\n"
    "  ariadne-experiment submit ini/paper/small.ini --out /shared/small --engine slurm \\\n"
    "      --partition short --time 2:00:00 --array-limit 50\n"
    "  ariadne-experiment submit ini/paper/small.ini --out /shared/small --script-only\n"
    "  ariadne-experiment submit ini/paper/small.ini --out /shared/small --engine parallel \\\n"
    "      --sshloginfile machines.txt";

const std::map<std::string, Engine>& engines() {
  static const std::map<std::string, Engine> all = {{"slurm", Engine::slurm},
                                                    {"parallel", Engine::parallel}};
  return all;
}

}  // namespace

CLI::App* addSubmit(CLI::App& app, Options& o) {
  CLI::App* sub = app.add_subcommand("submit", "Hand the runs without a result to a cluster");
  sub->footer(kSubmitFooter);
  sub->add_option("EXPERIMENT", o.ini, "INI of the experiment")->required();
  sub->add_option("--out", o.folder, "results folder, shared by all machines")->required();
  sub->add_option("--engine", o.engine, "slurm (default) or parallel")->transform(oneOf(engines()));
  sub->add_option("--slices", o.handed_slices,
                  "into how many tasks the plan is cut; default: one per run, at most 1000")
      ->check(CLI::Range(1, 4000000));
  sub->add_option("--jobs", o.jobs, "runs at a time in a task; default 1")
      ->check(CLI::Range(1, 1024));
  sub->add_option("--first", o.first, "first seed, instead of the INI's")
      ->check(CLI::NonNegativeNumber);
  sub->add_option("--last", o.last, "last seed, instead of the INI's")
      ->check(CLI::NonNegativeNumber);
  sub->add_flag("--again-failed", o.again_failed, "do runs that failed again");

  const auto slurm = [sub](CLI::Option* option) { option->group("With --engine slurm"); };
  slurm(sub->add_option("--partition", o.slurm.partition, "of the job"));
  slurm(sub->add_option("--time", o.slurm.time, "limit of a task, as 2:00:00 or 1-12"));
  slurm(sub->add_option("--mem", o.slurm.memory, "of a task, as 4G"));
  slurm(sub->add_option("--array-limit", o.slurm.array_limit, "tasks at a time")
            ->check(CLI::Range(1, 1000000)));
  slurm(sub->add_option("--sbatch", o.slurm.more, "any option of sbatch, as --sbatch=--account=lab")
            ->expected(1)
            ->take_all());
  slurm(sub->add_flag("--script-only", o.script_only, "write the batch script and stop"));

  const auto parallel = [sub](CLI::Option* option) { option->group("With --engine parallel"); };
  parallel(
      sub->add_option("--sshloginfile", o.parallel.sshloginfile,
                      "machines, as GNU parallel takes them: one per line, \":\" is this one"));
  parallel(sub->add_option("--host-limit", o.parallel.host_limit,
                           "slices at a time on a machine; default: as many as its cores can take")
               ->check(CLI::Range(1, 4096)));
  return sub;
}

}  // namespace ariadne::experiment_app
