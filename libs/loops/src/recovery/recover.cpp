#include "ariadne/loops/recovery/recover.h"

#include <map>

#include "attach.h"
#include "attached_paths.h"
#include "draw.h"
#include "positions_after.h"

namespace ariadne::loops {
namespace {

/// Entries of one ancestor that got one path are one hypothesis: its map is made once.
std::vector<std::size_t> twinsOf(const SavedSet& saved, const std::vector<std::size_t>& sources) {
  std::map<std::pair<const filter::Ancestor*, std::size_t>, std::size_t> first;
  std::vector<std::size_t> twins;
  for (std::size_t e = 0; e < sources.size(); ++e)
    twins.push_back(first.try_emplace({saved.entries[e].at_te.get(), sources[e]}, e).first->second);
  return twins;
}

}  // namespace

RecoveredSet recover(const SavedSet& saved, const filter::ParticleSet& present,
                     const std::vector<PlaceGraph>& graphs, const RecoveryInputs& inputs,
                     Draw draw) {
  const std::size_t n = saved.entries.size();
  RecoveredSet out;
  out.sources = drawSources(saved, present, draw, inputs.seed);
  const std::vector<std::size_t> twins = twinsOf(saved, out.sources);
  out.particles.resize(n);
  out.graphs.resize(n);
  out.contradiction.resize(n);
  AttachedPaths paths(saved.te);
  std::vector<filter::AncestorPtr> leaves;
  for (std::size_t e = 0; e < n; ++e)
    leaves.push_back(paths.attach(saved.entries[e].at_te, present[out.sources[e]].ancestor));
  inputs.parallel.forEach(n, [&](std::size_t e) {
    if (twins[e] != e) return;
    const SavedEntry& entry = saved.entries[e];
    const grid::OccupancyGrid map = mapAtTe(entry, inputs.shapes);
    out.particles[e] = attach(entry, map, leaves[e], inputs.shapes, inputs.checkpoint_updates);
    out.contradiction[e] = contradiction(map, leaves[e], saved.te, inputs.shapes);
    out.graphs[e] = entry.graph;
    out.graphs[e].attach(graphs[out.sources[e]], positionsAfter(leaves[e], saved.te));
  });
  for (std::size_t e = 0; e < n; ++e) {
    out.weights.push_back(saved.entries[e].weight);
    if (twins[e] == e) continue;
    out.particles[e] = out.particles[twins[e]];
    out.graphs[e] = out.graphs[twins[e]];
    out.contradiction[e] = out.contradiction[twins[e]];
  }
  return out;
}

}  // namespace ariadne::loops
