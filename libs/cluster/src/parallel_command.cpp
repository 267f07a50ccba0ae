#include "ariadne/cluster/parallel_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace ariadne::cluster {

std::vector<std::string> parallelCommand(const WorkerCall& worker, const ParallelOptions& options,
                                         const std::filesystem::path& joblog,
                                         const std::vector<std::size_t>& slices) {
  const int cores = worker.jobs * worker.threads;
  const std::string limit = options.host_limit > 0 ? std::to_string(options.host_limit)
                                                   : fmt::format("{}%", std::max(1, 100 / cores));
  // {} is parallel's; the rest is read by a shell of the machine.
  const std::string call = fmt::format(
      "{} work {} --slice {{}}/{} --jobs {} --quiet", shellWord(worker.program.string()),
      shellWord(worker.folder.string()), worker.slices, worker.jobs);
  // A machine that cannot be reached, or no longer: others do its slices.
  std::vector<std::string> words{"parallel",
                                 "--will-cite",
                                 "--sshloginfile",
                                 options.sshloginfile.string(),
                                 "--filter-hosts",
                                 "--retries",
                                 "3",
                                 "--joblog",
                                 joblog.string(),
                                 "--jobs",
                                 limit,
                                 call,
                                 ":::"};
  for (const std::size_t slice : slices) words.push_back(std::to_string(slice));
  return words;
}

JoblogCounts readJoblog(const std::filesystem::path& joblog) {
  std::ifstream file(joblog);
  std::map<std::string, bool> ok;  // by number: a slice that was tried again counts as at last
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    // Seq Host Starttime JobRuntime Send Receive Exitval Signal Command
    std::istringstream stream(line);
    std::vector<std::string> fields;
    for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
    if (fields.size() >= 8) ok[fields[0]] = fields[6] == "0" && fields[7] == "0";
  }
  JoblogCounts counts;
  for (const auto& [number, well] : ok) {
    ++counts.ended;
    counts.failed += well ? 0 : 1;
  }
  return counts;
}

}  // namespace ariadne::cluster
