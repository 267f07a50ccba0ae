// Ancestry of the paths through a loop once they are attached to the hypotheses of its entry, Eq.
// (13).
#pragma once
#include <cstddef>
#include <map>
#include <unordered_map>

#include "ariadne/filter/ancestry.h"

namespace ariadne::loops {

/// Makes the nodes x~_k = x~_te (+) (x_te^-1 (+) x_k): motion relative to te, since absolute
/// coordinates would erase the differences that were saved. The same entry and the same source node
/// make the same node: what two paths share they share still, so that distinct ancestors are
/// counted as those of a filter that never stopped.
class AttachedPaths {
 public:
  explicit AttachedPaths(std::size_t te) : te_(te) {}

  /// The line of `source` after te, attached to `at_te`; increments of the log weight are kept.
  /// @return its leaf
  filter::AncestorPtr attach(const filter::AncestorPtr& at_te, const filter::AncestorPtr& source);

 private:
  using Copies = std::unordered_map<const filter::Ancestor*, filter::AncestorPtr>;

  std::size_t te_;
  std::map<const filter::Ancestor*, Copies> copies_;  // by entry, then by source node
};

}  // namespace ariadne::loops
