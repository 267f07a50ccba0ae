#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "ariadne/core/parallel.h"

using ariadne::core::Parallel;

TEST(Parallel, CallsEachIndexOnce) {
  for (int threads : {1, 2, 8}) {
    std::vector<int> calls(1000, 0);
    Parallel(threads).forEach(calls.size(), [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads << " threads";
  }
}

TEST(Parallel, RethrowsWhatABodyThrows) {
  for (int threads : {1, 4})
    EXPECT_THROW(Parallel(threads).forEach(10,
                                           [](std::size_t i) {
                                             if (i == 7) throw std::runtime_error("7");
                                           }),
                 std::runtime_error);
}

TEST(Parallel, NothingToDoIsFine) {
  Parallel(4).forEach(0, [](std::size_t) { FAIL(); });
}
