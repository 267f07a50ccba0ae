// How much of the past the particles still disagree about.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/filter/ancestry.h"

namespace ariadne::eval {

/// Number of distinct ancestors at every step 0 .. steps - 1: the curve of coalescence. 1 where all
/// particles descend from one, 0 at steps of which no line has a node. Time grows with the number
/// of distinct ancestors.
std::vector<std::size_t> uniqueAncestors(const std::vector<filter::AncestorPtr>& leaves,
                                         std::size_t steps);

}  // namespace ariadne::eval
