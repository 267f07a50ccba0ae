#include "draw.h"

#include <algorithm>

namespace ariadne::loops {
namespace {

/// One of the candidates by weight; `u` in (0, 1).
std::size_t pick(const std::vector<std::size_t>& candidates, const std::vector<double>& weights,
                 double u) {
  double sum = 0;
  for (const std::size_t i : candidates) sum += weights[i];
  double left = u * sum;
  for (const std::size_t i : candidates) {
    left -= weights[i];
    if (left < 0) return i;
  }
  return candidates.back();
}

}  // namespace

std::vector<std::size_t> drawSources(const SavedSet& saved, const filter::ParticleSet& present,
                                     Draw draw, std::uint64_t seed) {
  const std::vector<double> weights = present.weights();
  std::vector<std::size_t> all(present.size());
  std::vector<filter::AncestorPtr> at_saving(present.size());
  for (std::size_t i = 0; i < present.size(); ++i) {
    all[i] = i;
    at_saving[i] = filter::ancestorAt(present[i].ancestor, saved.saving);
  }
  const auto step = static_cast<std::uint32_t>(present.step());
  const auto uniform = [&](std::size_t entry) {
    return core::RandomStream(seed, step, static_cast<std::uint32_t>(entry),
                              core::Purpose::recovery)
        .uniform();
  };
  std::vector<std::size_t> sources;
  for (std::size_t e = 0; e < saved.entries.size(); ++e) {
    std::vector<std::size_t> own;
    if (draw == Draw::own_descendant_first)
      std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                   [&](std::size_t i) { return at_saving[i] == saved.entries[e].at_saving; });
    sources.push_back(
        pick(own.empty() ? all : own, weights, uniform(draw == Draw::shared ? 0 : e)));
  }
  return sources;
}

}  // namespace ariadne::loops
