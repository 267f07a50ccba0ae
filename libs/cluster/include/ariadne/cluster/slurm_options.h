// What a user may say about a Slurm job, checked before sbatch is called.
#pragma once
#include <string>
#include <vector>

namespace ariadne::cluster {

/// What sbatch is told; empty or 0: the cluster's own choice.
struct SlurmOptions {
  std::string partition;
  std::string time;               ///< of a task, in Slurm's notation; empty: the partition's
  std::string memory;             ///< of a task, as "4G"; empty: the partition's
  int array_limit = 0;            ///< tasks at a time; 0: as many as Slurm gives
  std::vector<std::string> more;  ///< further options of sbatch, as "--account=lab"
};

/// Throws core::UsageError naming the option and what it takes.
void check(const SlurmOptions& options);

/// Of "90", "90:00", "1:30:00", "2-12", "2-12:30", "2-12:30:00", seconds; negative: none of these.
double slurmTime_s(const std::string& text);

}  // namespace ariadne::cluster
