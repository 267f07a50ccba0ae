#include "ariadne/filter/ancestry.h"

#include <algorithm>
#include <cmath>

#include "ariadne/core/release_chain.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::filter {

Ancestor::Ancestor(AncestorPtr parent, std::size_t step, const mrpt::math::TPose2D& map_from_robot,
                   double log_weight)
    : Ancestor(parent, step, map_from_robot, log_weight,
               parent ? geometry::relativePose(parent->pose(), map_from_robot)
                      : mrpt::math::TPose2D()) {}

Ancestor::~Ancestor() {
  core::releaseChain(
      std::move(parent_), [](const Ancestor& a) -> auto& { return a.parent_; });
}

AncestorPtr ancestorAt(const AncestorPtr& leaf, std::size_t step) {
  const AncestorPtr* a = &leaf;
  while (*a && (*a)->step() > step) a = &(*a)->parent();
  return *a && (*a)->step() == step ? *a : nullptr;
}

std::size_t distinctAncestors(const std::vector<AncestorPtr>& leaves, std::size_t step) {
  std::vector<const Ancestor*> nodes;
  for (const AncestorPtr& leaf : leaves) nodes.push_back(leaf.get());
  // Resampling lays children of one parent side by side, so lines mostly join as neighbours: walked
  // in step, they are soon few. Recovery mixes them, so the end needs a sort.
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  while (!nodes.empty() && nodes.front()->step() > step) {
    for (const Ancestor*& n : nodes) n = n->parent().get();
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  std::sort(nodes.begin(), nodes.end());
  return static_cast<std::size_t>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

std::size_t earlierPasses(const AncestorPtr& leaf, double radius_m) {
  if (!leaf) return 0;
  const auto here = leaf->pose();
  std::size_t runs = 0;
  bool inside = false;
  forEachAncestor(leaf, [&](const Ancestor& a) {
    const bool near = geometry::distance(a.pose(), here) < radius_m;
    if (near && !inside) ++runs;
    inside = near;
    return true;
  });
  return runs - 1;  // the leaf's own run
}

}  // namespace ariadne::filter
