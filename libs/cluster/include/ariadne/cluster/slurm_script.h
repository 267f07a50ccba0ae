// The batch script of a job array whose tasks each do a slice.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/cluster/shell.h"
#include "ariadne/cluster/slurm_options.h"

namespace ariadne::cluster {

/// A file name of an #SBATCH line, where % is a pattern. Throws core::UsageError for one that
/// sbatch cannot read.
std::string sbatchName(const std::filesystem::path& path);

/// @param name of the job
/// @param logs folder of the tasks' logs, slice-N.log
/// @param slices those to do, in rising order, at least one
/// Throws core::UsageError for a folder whose name sbatch cannot read.
std::string slurmScript(const WorkerCall& worker, const SlurmOptions& options,
                        const std::string& name, const std::filesystem::path& logs,
                        const std::vector<std::size_t>& slices);

}  // namespace ariadne::cluster
