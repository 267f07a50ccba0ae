// How much of the past the particles still disagree about, and how much of it was lost.
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

/// The share of the distinct ancestors of `true_set_at_te` that have a descendant among `leaves`
/// (or are one), 0 to 1: what Section V of the paper puts at about 75 %. Ancestors are told apart
/// by identity, so two particles that share their node at te are one.
/// Throws core::Error when the true set is empty, or holds a null or a node of another step.
double survivors(const std::vector<filter::AncestorPtr>& true_set_at_te,
                 const std::vector<filter::AncestorPtr>& leaves, std::size_t te);

}  // namespace ariadne::eval
