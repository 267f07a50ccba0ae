// What the results have come to: the table on the terminal, plots and report.html in the folder.
#pragma once
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/plots.h"
#include "ariadne/batch/store.h"
#include "ariadne/batch/tables.h"

namespace ariadne::experiment_app {

class ResultsOutput {
 public:
  /// Reads all results. Both references must outlive this. Throws core::UsageError for a figure
  /// that no run has, core::Error for a damaged result.
  ResultsOutput(const batch::Plan& plan, const batch::Store& store);

  const std::map<std::string, batch::RunResult>& results() const { return results_; }
  std::string table(batch::TableFormat format) const;
  /// table.txt, .csv, .md and .tex in a folder, which is made.
  void writeTables(const std::filesystem::path& folder) const;
  /// What is worth committing, in a folder, which is made: the tables, runs.csv and plots as SVG.
  /// No times of runs, hosts or paths: the same results are the same bytes on any machine. Without
  /// gnuplot no plots, and a warning on `err`.
  void exportTo(const std::filesystem::path& folder, std::ostream& err) const;
  /// FOLDER/plots. Throws core::Error, also when gnuplot is missing.
  void writePlots() const;
  /// FOLDER/report.html and plots. Without gnuplot a page without pictures, and a warning on `err`.
  void writeReport(std::ostream& err) const;

 private:
  /// None, and a warning on `err`, without gnuplot.
  std::vector<batch::Picture> picturesOr(const std::vector<batch::Plot>& plots,
                                         std::ostream& err) const;
  const batch::Plan& plan_;
  const batch::Store& store_;
  std::map<std::string, batch::RunResult> results_;
  std::vector<batch::Cell> cells_;
};

}  // namespace ariadne::experiment_app
