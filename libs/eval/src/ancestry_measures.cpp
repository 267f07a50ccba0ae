#include "ariadne/eval/ancestry_measures.h"

#include <fmt/format.h>

#include <unordered_set>

#include "ariadne/core/error.h"
#include "ariadne/eval/ancestor_levels.h"

namespace ariadne::eval {

std::vector<std::size_t> uniqueAncestors(const std::vector<filter::AncestorPtr>& leaves,
                                         std::size_t steps) {
  std::vector<std::size_t> counts(steps, 0);
  for (AncestorLevels walk(leaves); !walk.done(); walk.up())
    if (walk.step() < steps) counts[walk.step()] = walk.level().size();
  return counts;
}

double survivors(const std::vector<filter::AncestorPtr>& true_set_at_te,
                 const std::vector<filter::AncestorPtr>& leaves, std::size_t te) {
  std::unordered_set<const filter::Ancestor*> existed;
  for (const auto& a : true_set_at_te) {
    if (!a || a->step() != te)
      throw core::Error(fmt::format("the true set at step {} holds {}: it takes nodes of that step",
                                    te, a ? fmt::format("one of step {}", a->step()) : "a null"));
    existed.insert(a.get());
  }
  if (existed.empty()) throw core::Error("survivors of an empty set are not defined");
  AncestorLevels walk(leaves);
  while (!walk.done() && walk.step() > te) walk.up();
  std::size_t alive = 0;
  if (!walk.done() && walk.step() == te)
    for (const auto& e : walk.level()) alive += existed.count(e.node);
  return static_cast<double>(alive) / static_cast<double>(existed.size());
}

}  // namespace ariadne::eval
