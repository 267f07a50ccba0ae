// The interval of a median as tables and plots show it.
#pragma once
#include <vector>

#include "ariadne/statistics/interval.h"

namespace ariadne::batch {

/// Bootstrap, 95 %. Depends on nothing but the values, of which there must be one.
statistics::Interval medianInterval95(const std::vector<double>& values);

}  // namespace ariadne::batch
