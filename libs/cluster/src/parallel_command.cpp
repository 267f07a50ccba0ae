#include "ariadne/cluster/parallel_command.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

namespace ariadne::cluster {

std::vector<std::string> parallelCommand(const WorkerCall& worker, const ParallelOptions& options,
                                         const std::filesystem::path& joblog,
                                         const std::vector<std::size_t>& slices) {
  const int cores = worker.jobs * worker.threads;
  std::vector<std::string> words{
      "parallel", "--will-cite",
      // parallel reads {} in it, and the machine's shell the rest
      "--sshloginfile", options.sshloginfile.string(), "--joblog", joblog.string(),
      // a machine that is away or goes away: its slices are done on another
      "--filter-hosts", "--retries", "3", "--jobs",
      options.host_limit > 0 ? std::to_string(options.host_limit)
                             : fmt::format("{}%", std::max(1, 100 / cores)),
      fmt::format("{} work {} --slice {{}}/{} --jobs {} --quiet",
                  shellWord(worker.program.string()), shellWord(worker.folder.string()),
                  worker.slices, worker.jobs),
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
    std::istringstream fields(line);
    std::string number, ignored, exit_code, signal;
    fields >> number >> ignored >> ignored >> ignored >> ignored >> ignored >> exit_code >> signal;
    if (!signal.empty()) ok[number] = exit_code == "0" && signal == "0";
  }
  JoblogCounts counts;
  for (const auto& [number, well] : ok) {
    ++counts.ended;
    counts.failed += well ? 0 : 1;
  }
  return counts;
}

}  // namespace ariadne::cluster
