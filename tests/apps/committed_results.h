// What ariadne-experiment export wrote, read back, and the bounds that committed runs give new
// ones.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::test {

/// A runs.csv: seed, values of the factors, arm, failed, success (where it is judged), figures.
struct Runs {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  std::size_t column(const std::string& name) const;  ///< columns.size() when there is none
};

/// Throws core::Error when the file cannot be read.
Runs readRuns(const std::filesystem::path& file);

/// Every figure of each run must lie within the range of the committed runs of the same arm and
/// values of the factors, widened on both sides by half of its width, or by a twentieth of its
/// larger end where that is more. How that was found: another seed's run and a filter that draws
/// other numbers stay inside (the range is of 10 seeds or more), a filter that is broken does not.
/// Times (names that end in _s) must only be there. An unjudged run may lack figures. Fails, too,
/// for a run that failed and for one of which no like was committed.
void expectWithin(const Runs& runs, const Runs& committed);

}  // namespace ariadne::test
