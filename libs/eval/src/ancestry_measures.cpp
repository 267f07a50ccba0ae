#include "ariadne/eval/ancestry_measures.h"

#include "ariadne/eval/ancestor_levels.h"

namespace ariadne::eval {

std::vector<std::size_t> uniqueAncestors(const std::vector<filter::AncestorPtr>& leaves,
                                         std::size_t steps) {
  std::vector<std::size_t> counts(steps, 0);
  for (AncestorLevels walk(leaves); !walk.done(); walk.up())
    if (walk.step() < steps) counts[walk.step()] = walk.level().size();
  return counts;
}

}  // namespace ariadne::eval
