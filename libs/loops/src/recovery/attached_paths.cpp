#include "attached_paths.h"

#include <vector>

#include "ariadne/geometry/pose.h"

namespace ariadne::loops {

using filter::Ancestor;
using filter::AncestorPtr;

AncestorPtr AttachedPaths::attach(const AncestorPtr& at_te, const AncestorPtr& source) {
  Copies& copies = copies_[at_te.get()];
  AncestorPtr leaf = at_te;
  std::vector<const Ancestor*> missing;
  const Ancestor* node = source.get();
  for (; node->step() > te_; node = node->parent().get()) {
    const auto known = copies.find(node);
    if (known != copies.end()) {
      leaf = known->second;
      break;
    }
    missing.push_back(node);
  }
  if (missing.empty()) return leaf;
  const AncestorPtr source_at_te = filter::ancestorAt(source, te_);
  for (auto it = missing.rbegin(); it != missing.rend(); ++it) {
    const Ancestor& from = **it;
    const auto te_from_robot = geometry::relativePose(source_at_te->pose(), from.pose());
    // Eq. (13)
    leaf = std::make_shared<Ancestor>(leaf, from.step(),
                                      geometry::compose(at_te->pose(), te_from_robot),
                                      from.logWeight(), from.motion());
    copies.emplace(&from, leaf);
  }
  return leaf;
}

}  // namespace ariadne::loops
