#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/loop_table.h"

using namespace ariadne;
using experiment::LoopRow;

namespace {

std::vector<LoopRow> rows() {
  std::vector<LoopRow> all;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    LoopRow row{"ring", 10, seed, {}};
    row.result.recovered.chosen = row.result.recovered.exists = true;
    row.result.standard.chosen = seed == 1;
    row.result.standard.worst_translation_m = 1.0 / 3;
    if (seed != 4) row.result.inner = experiment::InnerLoop{0.1, 0.2, 0.3, 0.5, 1, 16, 0.4, 7, 0};
    all.push_back(row);
  }
  return all;
}

std::string csvOf(const std::vector<LoopRow>& rows) {
  std::string csv = experiment::rowsHeader() + "\n";
  for (const LoopRow& row : rows) csv += experiment::toLine(row) + "\n";
  return csv;
}

}  // namespace

TEST(LoopRows, ReadBackToTheSameBytes) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("ariadne-rows-" + std::to_string(::getpid()) + ".csv");
  const std::string csv = csvOf(rows());
  std::ofstream(file) << csv;
  EXPECT_EQ(csvOf(experiment::readRows(file)), csv);
  std::ofstream(file) << csv << "ring,10\n";
  EXPECT_THROW(experiment::readRows(file), core::Error);
  // A bool, a count and a lap that C++ could not convert.
  for (const char* wrong :
       {"ring,1e300,1,1,1", "ring,10,-1,1,1", "ring,10,1,nan,1", "ring,10,1,1,7"}) {
    const std::string line = csv.substr(csv.find("\nring") + 1);
    std::size_t cut = 0;
    for (int cell = 0; cell < 5; ++cell) cut = line.find(',', cut) + 1;
    std::ofstream(file) << csv << wrong << "," << line.substr(cut, line.find('\n') + 1 - cut);
    try {
      experiment::readRows(file);
      FAIL() << wrong;
    } catch (const core::Error& e) {
      EXPECT_NE(std::string(e.what()).find("takes a whole number"), std::string::npos) << e.what();
    }
  }
  std::string early = csvOf({rows()[0]});  // without the last columns, as the first version's
  for (std::size_t end : {early.size() - 1, early.find('\n')}) {
    std::size_t at = end;
    for (int cells = 0; cells < 5; ++cells) at = early.rfind(',', at - 1);
    early.erase(at, end - at);
  }
  std::ofstream(file) << early;
  const auto read = experiment::readRows(file);
  ASSERT_EQ(read.size(), 1U) << early;
  EXPECT_EQ(read[0].result.inner->distinct_saved, 16U);
  EXPECT_TRUE(std::isnan(read[0].result.inner->recovery_s));
  std::ofstream(file) << "a,b\n";
  EXPECT_THROW(experiment::readRows(file), core::Error);
  std::filesystem::remove(file);
}

TEST(LoopTable, HasRatesIntervalsAndTheTest) {
  const std::string table = experiment::loopTable(rows());
  EXPECT_NE(table.find("| ring | 10 | 1/10 (10 % [2-40])"), std::string::npos) << table;
  EXPECT_NE(table.find("10/10 (100 % [72-100])"), std::string::npos) << table;
  EXPECT_NE(table.find("| 9 / 0 | 0.0039 |"), std::string::npos) << "2 / 2^9";
  EXPECT_NE(table.find("| ring | 10 | 9 | 0.50 | 1.00, 16.00 |"), std::string::npos) << table;
}
