#include "ariadne/cluster/slurm_script.h"

#include <fmt/format.h>

#include "ariadne/cluster/slices.h"
#include "ariadne/core/error.h"

namespace ariadne::cluster {
namespace {

constexpr const char* kScript = R"sh(#!/bin/sh
# Each task does one of {slices} slices of a plan; written by ariadne-experiment submit.
{header}
program={program}
folder={folder}
echo "$(date '+%F %T') slice $SLURM_ARRAY_TASK_ID/{slices} on $(hostname), start $((${{SLURM_RESTART_COUNT:-0}} + 1))"
for needed in "$program" "$folder/plan.json"; do
  [ -e "$needed" ] && continue
  echo "$(hostname) does not see $needed: results and programs must lie where all nodes see them" >&2
  exit 1
done
# exec: Slurm's signals reach the worker, which gives back the runs that it has not finished.
exec "$program" work "$folder" --slice "$SLURM_ARRAY_TASK_ID/{slices}" --jobs {jobs}
)sh";

std::string headerOf(const WorkerCall& worker, const SlurmOptions& o, const std::string& name,
                     const std::filesystem::path& logs, const std::vector<std::size_t>& slices) {
  std::string array = rangesText(slices);
  if (o.array_limit > 0) array += fmt::format("%{}", o.array_limit);
  std::string text = fmt::format("#SBATCH --job-name={}\n#SBATCH --array={}\n", name, array);
  if (!o.partition.empty()) text += fmt::format("#SBATCH --partition={}\n", o.partition);
  if (!o.time.empty()) text += fmt::format("#SBATCH --time={}\n", o.time);
  if (!o.memory.empty()) text += fmt::format("#SBATCH --mem={}\n", o.memory);
  text += fmt::format(
      "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={}\n"
      "# A task that is preempted or whose node dies waits in the queue again; the log goes on.\n"
      "#SBATCH --requeue --open-mode=append --chdir=/\n"
      "#SBATCH --output=\"{}/slice-%a.log\"\n",
      worker.jobs * worker.threads, sbatchName(logs));
  for (const std::string& word : o.more) text += fmt::format("#SBATCH {}\n", word);
  return text;
}

}  // namespace

std::string sbatchName(const std::filesystem::path& path) {
  const std::string text = path.string();
  if (text.find_first_of("\"\\\n") != std::string::npos)
    throw core::UsageError(fmt::format(
        "{}: sbatch cannot read a name with a quote, backslash or line break in it", text));
  std::string out;
  for (const char c : text) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out;
}

std::string slurmScript(const WorkerCall& worker, const SlurmOptions& options,
                        const std::string& name, const std::filesystem::path& logs,
                        const std::vector<std::size_t>& slices) {
  return fmt::format(kScript, fmt::arg("slices", worker.slices),
                     fmt::arg("header", headerOf(worker, options, name, logs, slices)),
                     fmt::arg("program", shellWord(worker.program.string())),
                     fmt::arg("folder", shellWord(worker.folder.string())),
                     fmt::arg("jobs", worker.jobs));
}

}  // namespace ariadne::cluster
