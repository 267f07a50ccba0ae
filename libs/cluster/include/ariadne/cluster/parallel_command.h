// Slices by GNU parallel over ssh.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/cluster/shell.h"

namespace ariadne::cluster {

/// How GNU parallel is called.
struct ParallelOptions {
  std::filesystem::path sshloginfile;  ///< a machine a line; ":" is this one
  int host_limit = 0;                  ///< slices at a time on a machine; 0: by its cores
};

/// Words of the command that does all of `slices`, one at a time for every core that a slice takes.
/// @param joblog file that parallel writes about each
std::vector<std::string> parallelCommand(const WorkerCall& worker, const ParallelOptions& options,
                                         const std::filesystem::path& joblog,
                                         const std::vector<std::size_t>& slices);

/// Slices that ended, and those of them that ended badly at last, by a joblog.
struct JoblogCounts {
  std::size_t ended = 0;
  std::size_t failed = 0;
};
/// Empty where there is no such file. A slice that was tried again counts as it ended at last.
JoblogCounts readJoblog(const std::filesystem::path& joblog);

}  // namespace ariadne::cluster
