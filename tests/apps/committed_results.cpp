#include "committed_results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ariadne/io/csv.h"

namespace ariadne::test {
namespace {

using Row = std::vector<std::string>;

/// Values of the factors and the arm: what stands between seed and failed.
Row likes(const Runs& runs, const Row& row) {
  return {row.begin() + 1, row.begin() + static_cast<long>(runs.column("failed"))};
}

struct Range {
  double least = INFINITY;
  double most = -INFINITY;

  bool holds(double v) const {
    const double slack =
        std::max((most - least) / 2, 0.05 * std::max(std::abs(least), std::abs(most)));
    return v >= least - slack && v <= most + slack;
  }
};

Range rangeOf(const Runs& committed, const Row& like, std::size_t column) {
  Range range;
  for (const Row& row : committed.rows) {
    if (likes(committed, row) != like || row[column].empty()) continue;
    range.least = std::min(range.least, std::stod(row[column]));
    range.most = std::max(range.most, std::stod(row[column]));
  }
  return range;
}

bool isTime(const std::string& figure) {
  return figure.size() > 2 && figure.compare(figure.size() - 2, 2, "_s") == 0;
}

}  // namespace

std::size_t Runs::column(const std::string& name) const {
  return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                  columns.begin());
}

Runs readRuns(const std::filesystem::path& file) {
  const io::CsvTable table = io::readCsv(file);
  Runs runs{table.header(), {}};
  for (std::size_t i = 0; i < table.size(); ++i) runs.rows.push_back(table.row(i));
  return runs;
}

void expectWithin(const Runs& runs, const Runs& committed) {
  ASSERT_EQ(runs.columns, committed.columns) << "committed by another INI: scripts/paper-results";
  const std::size_t failed = runs.column("failed");
  const std::size_t judged = runs.column("success") < runs.columns.size() ? 1 : 0;
  for (const Row& row : runs.rows) {
    EXPECT_EQ(row[failed], "0");
    for (std::size_t i = failed + 1 + judged; i < row.size(); ++i) {
      const Range range = rangeOf(committed, likes(runs, row), i);
      if (judged && row[failed + 1] == "unjudged" && row[i].empty()) continue;
      if (row[i].empty() || isTime(runs.columns[i])) {
        EXPECT_EQ(row[i].empty(), range.most < range.least) << runs.columns[i];
        continue;
      }
      EXPECT_TRUE(range.holds(std::stod(row[i])))
          << runs.columns[i] << " = " << row[i] << " of seed " << row[0] << ", arm "
          << row[failed - 1] << ": committed are " << range.least << " to " << range.most;
    }
  }
}

}  // namespace ariadne::test
