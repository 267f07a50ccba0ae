// The results folder: what is to be done and what is. Shared by all processes and machines that
// work on it; every file is renamed into place.
//
//   plan.json  configs/HASH.ini  runs/KEY.json  files/KEY/  claims/  scratch/OWNER/KEY/
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/run_result.h"

namespace ariadne::batch {

/// The results folder of an experiment, its only state: plan, configurations, results, claims.
class Store {
 public:
  /// Of this folder, which need not exist yet; nothing is made or read here.
  explicit Store(std::filesystem::path folder);

  /// Makes the folder ready for the plan; results that are there stay. Throws core::UsageError for
  /// a folder of another experiment or one that holds something else, core::Error when it cannot
  /// be written.
  void writePlan(const Plan& plan) const;
  /// Throws core::UsageError when the folder holds no plan, core::Error when it is damaged.
  Plan readPlan() const;

  /// Whether the run has a result, failed ones too.
  bool has(const std::string& key) const;
  /// Nothing when the run has no result. Throws core::Error for a damaged one.
  std::optional<RunResult> result(const std::string& key) const;
  /// Of all runs of the plan that have one, by key.
  std::map<std::string, RunResult> results(const Plan& plan) const;
  /// Whole or not at all; a failure does not replace a success.
  void put(const RunResult& result) const;
  /// Removes the run's result, so that it is done again; its files stay until then.
  void forget(const std::string& key) const;
  /// Removes what a dead owner of claims (Claims::owner) left half done.
  void clearAfter(const std::string& owner) const;
  /// Throws core::Error when nothing can be written (any more).
  void probe() const;

  /// The frozen INI with this hash of its text.
  std::filesystem::path config(const std::string& hash) const;
  /// The folder of claims (class Claims).
  std::filesystem::path claims() const { return folder_ / "claims"; }
  /// Where the runs of one owner of claims write while they go.
  std::filesystem::path scratch(const std::string& owner) const;
  /// What a run wrote, where it is kept.
  std::filesystem::path files(const std::string& key) const { return folder_ / "files" / key; }
  /// The results folder itself.
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path file(const std::string& key) const;
  void refuseOthers(const Plan& plan) const;
  std::filesystem::path folder_;
};

}  // namespace ariadne::batch
