// Where a line was after te, for its graph of places.
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <vector>

#include "ariadne/filter/ancestry.h"

namespace ariadne::loops {

/// m, map frame, in the order of time.
inline std::vector<mrpt::math::TPoint2D> positionsAfter(const filter::AncestorPtr& leaf,
                                                        std::size_t te) {
  std::vector<mrpt::math::TPoint2D> positions;
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    if (a.step() <= te) return false;
    positions.emplace_back(a.pose().x, a.pose().y);
    return true;
  });
  return {positions.rbegin(), positions.rend()};
}

}  // namespace ariadne::loops
