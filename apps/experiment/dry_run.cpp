#include "dry_run.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>
#include <set>

#include "run_progress.h"

namespace ariadne::experiment_app {
namespace {

namespace fs = std::filesystem;
using batch::Plan;
using batch::PlannedRun;

/// One line of the plan: all seeds of an arm at one combination.
struct Group {
  std::string name;
  std::size_t runs = 0;
  std::size_t done = 0;
  double wall_s = 0;  ///< of those
};

std::string nameOf(const Plan& plan, const PlannedRun& run) {
  const std::string all = batch::describe(plan, run);
  return all.substr(all.find(", ") + 2);  // without the seed
}

std::uintmax_t sizeOf(const fs::path& path) {
  std::error_code error;
  if (fs::is_regular_file(path, error)) return fs::file_size(path, error);
  std::uintmax_t sum = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path, error))
    if (entry.is_regular_file(error)) sum += entry.file_size(error);
  return sum;
}

void printEstimate(const Plan& plan, const batch::Store& store, const std::vector<Group>& groups,
                   int jobs, std::ostream& out) {
  double left_s = 0;
  std::size_t done = 0;
  bool known = true;
  for (const Group& g : groups) {
    done += g.done;
    known = known && (g.done > 0 || g.runs == 0);
    if (g.done > 0)
      left_s += g.wall_s / static_cast<double>(g.done) * static_cast<double>(g.runs - g.done);
  }
  if (!known) {
    fmt::print(out,
               "No estimate before a run of each line is finished (--first {0} --last {0} does "
               "one); a run may take {1} s.\n",
               plan.runs.front().seed, plan.limits.time_s);
    return;
  }
  double bytes = 0;
  std::set<std::string> keys;
  for (const PlannedRun& run : plan.runs)
    if (store.has(run.key) && keys.insert(run.key).second)
      bytes += static_cast<double>(sizeOf(store.folder() / "runs" / (run.key + ".json")) +
                                   sizeOf(store.files(run.key)));
  const double each = bytes / static_cast<double>(keys.size());
  const double left = static_cast<double>(plan.runs.size() - done);
  fmt::print(out, "About {} on {} jobs and {:.2f} MB, by the {} finished.\n",
             app::timeText(left_s / jobs), jobs, each * left / 1e6, done);
}

}  // namespace

void printPlan(const Plan& plan, const batch::Store* store, int jobs, std::ostream& out) {
  std::vector<Group> groups;
  std::set<std::string> keys;
  std::size_t done = 0;
  const auto results = store ? store->results(plan) : std::map<std::string, batch::RunResult>();
  for (const PlannedRun& run : plan.runs) {
    const std::string name = nameOf(plan, run);
    // Every seed has the same groups in the same order.
    if (run.seed == plan.runs.front().seed) groups.push_back({name, 0, 0, 0});
    const auto index = static_cast<std::size_t>(&run - plan.runs.data());
    Group& group = groups[run.seed == plan.runs.front().seed ? index : index % groups.size()];
    keys.insert(run.key);
    ++group.runs;
    const auto found = results.find(run.key);
    if (found == results.end()) continue;
    ++group.done;
    ++done;
    group.wall_s += found->second.wall_s;
  }
  fmt::print(out, "{}: {} runs, {} of them different, {} finished\n", plan.title, plan.runs.size(),
             keys.size(), done);
  for (const Group& g : groups)
    fmt::print(out, "  {}: {} seeds, {} finished\n", g.name, g.runs, g.done);
  if (store && done == plan.runs.size())
    out << "Nothing is left to do.\n";
  else if (store)
    printEstimate(plan, *store, groups, jobs, out);
  else
    fmt::print(
        out, "With --out of some finished runs time and disk are estimated; a run may take {} s.\n",
        plan.limits.time_s);
}

}  // namespace ariadne::experiment_app
