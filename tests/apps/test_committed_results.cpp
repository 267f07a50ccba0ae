// The bounds that committed results give new runs must be able to fail.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "committed_results.h"

using ariadne::test::expectWithin;
using ariadne::test::Runs;

namespace {

const Runs kCommitted{{"seed", "laps", "arm", "failed", "success", "x_m", "cpu_s"},
                      {{"1", "0", "one", "0", "1", "10", "3"},
                       {"2", "0", "one", "0", "0", "20", "5"},
                       {"1", "3", "one", "0", "1", "100", "3"},
                       {"1", "3", "two", "0", "1", "", "3"}}};

Runs ran(const std::vector<std::string>& row) { return {kCommitted.columns, {row}}; }

}  // namespace

TEST(CommittedResults, HoldWhatIsWithinHalfTheirWidth) {
  expectWithin(ran({"7", "0", "one", "0", "0", "5", "900"}), kCommitted);
  expectWithin(ran({"7", "0", "one", "0", "1", "25", "3"}), kCommitted);
  expectWithin(ran({"7", "3", "one", "0", "1", "104", "3"}), kCommitted);
  expectWithin(ran({"7", "3", "two", "0", "1", "", "3"}), kCommitted);
  expectWithin(ran({"7", "0", "one", "0", "unjudged", "", "3"}), kCommitted);
}

TEST(CommittedResults, FailWhatIsNot) {
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "0", "one", "0", "0", "4.9", "3"}), kCommitted),
                          "x_m = 4.9");
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "0", "one", "0", "0", "25.1", "3"}), kCommitted),
                          "10 to 20");
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "3", "one", "0", "1", "106", "3"}), kCommitted),
                          "x_m = 106");
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "3", "two", "0", "1", "5", "3"}), kCommitted),
                          "x_m = 5");
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "0", "one", "0", "1", "", "3"}), kCommitted),
                          "x_m");
  EXPECT_NONFATAL_FAILURE(expectWithin(ran({"7", "0", "one", "1", "1", "15", "3"}), kCommitted),
                          "failed");
}
