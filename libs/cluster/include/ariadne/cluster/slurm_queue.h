// What Slurm is told and says: sbatch, squeue, sacct.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ariadne::cluster {

/// Hands the script over. Returns the job's number. Throws core::UsageError when there is no
/// sbatch, core::Error with what sbatch says, also when no line of that is a job's number.
std::string submitToSlurm(const std::filesystem::path& script);

/// A task that Slurm has not done with: pending, running, completing, ...
struct Task {
  std::string name;  ///< of its job
  std::string id;    ///< of its job
  std::size_t slice = 0;
  std::string state;   ///< "RUNNING"
  std::string reason;  ///< "Resources", of one that waits
};

/// What squeue says of our jobs.
struct Queue {
  std::string problem;  ///< empty: squeue answered
  std::vector<Task> tasks;
};

/// All tasks of jobs with these names, of any user.
Queue askSqueue(const std::vector<std::string>& names);

/// What sacct says of jobs that have ended.
struct Account {
  std::string problem;                        ///< empty: sacct answered
  std::map<std::string, std::size_t> states;  ///< tasks by state
};

/// Where the cluster keeps accounts, how all tasks of a job are or ended.
Account askSacct(const std::string& id);

}  // namespace ariadne::cluster
