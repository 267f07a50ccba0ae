// Interval estimates of rates and medians.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/core/random.h"

namespace ariadne::statistics {

/// Of confidence, ends included.
struct Interval {
  double low = 0;
  double high = 0;
};

/// Wilson's score interval of a rate, without continuity correction (Wilson 1927; method 3 of
/// Newcombe, Statistics in Medicine 17, 1998). Stays in [0, 1]; 0 of n does not shrink to a point.
/// Throws core::Error for no trial or more successes than trials, core::UsageError for a confidence
/// not between 0 and 1.
Interval wilsonInterval(std::size_t successes, std::size_t trials, double confidence = 0.95);

/// Percentile bootstrap interval of the median (Efron and Tibshirani 1993, chapter 13): the
/// order statistics (resamples + 1) (1 -+ confidence) / 2 of the medians of samples drawn with
/// replacement. The same stream gives the same bits. Under ten values its cover is less than named.
/// @param values finite, at least one; core::Error when not
/// @param resamples at least 1; 9999 puts the ends of the usual intervals on an order statistic
Interval medianInterval(std::vector<double> values, core::RandomStream& rng,
                        double confidence = 0.95, std::size_t resamples = 9999);

}  // namespace ariadne::statistics
