// What was handed to a cluster, in jobs/ of the results folder: for each call of submit a folder
// jobs/NUMBER with job.json, the script and the tasks' logs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::cluster {

/// One call of submit: a folder with its script and slices.
struct Submission {
  std::size_t number = 0;
  std::string engine;  ///< "slurm", "parallel"
  std::string name;    ///< of Slurm's job; no other submission has it
  std::string id;      ///< Slurm's number; empty: not known, as of a script handed over by hand
  std::size_t slices = 1;
  std::vector<std::size_t> handed;  ///< of these, in rising order
  std::string plan;                 ///< hash of the plan.json that was sliced
};

/// All submissions of a results folder.
class Submissions {
 public:
  /// @param results the results folder
  explicit Submissions(std::filesystem::path results);

  /// A folder and name that are nobody else's, also when two submit at once. Throws core::Error.
  Submission begin(const std::string& engine) const;
  /// Writes job.json, whole. Throws core::Error.
  void put(const Submission& submission) const;
  /// Those with a job.json, by number. Throws core::Error for a damaged one.
  std::vector<Submission> all() const;
  /// Where its script, slices and output lie.
  std::filesystem::path folder(const Submission& submission) const;

 private:
  std::filesystem::path results_;
};

}  // namespace ariadne::cluster
