#include "ariadne/filter/ancestry.h"

#include <cmath>

namespace ariadne::filter {

// A long line must not be freed by recursion: ten thousand steps would overflow the stack.
Ancestor::~Ancestor() {
  AncestorPtr next = std::move(parent_);
  while (next && next.use_count() == 1) {
    AncestorPtr above = std::move(next->parent_);
    next = std::move(above);
  }
}

std::size_t earlierPasses(const AncestorPtr& leaf, double radius_m) {
  if (!leaf) return 0;
  const auto here = leaf->pose();
  std::size_t runs = 0;
  bool inside = false;
  forEachAncestor(leaf, [&](const Ancestor& a) {
    const bool near = std::hypot(a.pose().x - here.x, a.pose().y - here.y) < radius_m;
    if (near && !inside) ++runs;
    inside = near;
    return true;
  });
  return runs - 1;  // the leaf's own run
}

}  // namespace ariadne::filter
