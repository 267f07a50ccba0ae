#include "experiment_status.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>
#include <set>

#include "ariadne/batch/run_counts.h"
#include "run_progress.h"

namespace ariadne::experiment_app {
namespace {

namespace fs = std::filesystem;

/// The last line that says something.
std::string lastLine(std::string words) {
  while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
  return words.substr(words.rfind('\n') + 1);
}

void printOwners(const batch::Store& store, std::ostream& out) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(store.claims() / "owners", ignored)) {
    const auto age = fs::file_time_type::clock::now() - entry.last_write_time(ignored);
    fmt::print(out, "Works on it: {}, last sign of life {} s ago\n",
               entry.path().filename().string(),
               std::chrono::duration_cast<std::chrono::seconds>(age).count());
  }
}

}  // namespace

void printStatus(const batch::Plan& plan, const batch::Store& store, std::ostream& out) {
  const auto results = store.results(plan);
  const batch::Counts counts = batch::countRuns(plan, results);
  fmt::print(out, "{}: {} runs, {} finished, {} failed, {} to do\n", plan.title, counts.planned,
             counts.finished, counts.failed, counts.planned - counts.finished - counts.failed);
  double wall_s = 0;
  double cpu_s = 0;
  for (const auto& [key, r] : results) {
    wall_s += r.wall_s;
    cpu_s += r.cpu_s;
  }
  if (!results.empty())
    fmt::print(out, "Taken so far: {} of wall clock, {} of CPU; {:.1f} s per run\n",
               app::timeText(wall_s), app::timeText(cpu_s),
               wall_s / static_cast<double>(results.size()));
  printOwners(store, out);
  std::set<std::string> told;
  for (const auto& run : plan.runs) {
    const auto r = results.find(run.key);
    if (r == results.end() || r->second.failure.empty() || !told.insert(run.key).second) continue;
    const std::string words = lastLine(r->second.last_words);
    fmt::print(out, "Failed: {} ({}.json): {}{}{}\n", batch::describe(plan, run), run.key,
               r->second.failure, words.empty() ? "" : ": ", words);
  }
}

}  // namespace ariadne::experiment_app
