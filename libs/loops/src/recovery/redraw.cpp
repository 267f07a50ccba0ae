#include "ariadne/loops/recovery/redraw.h"

#include "attach.h"
#include "positions_after.h"

namespace ariadne::loops {

RecoveredSet redraw(const SavedSet& present, const std::vector<filter::AncestorPtr>& leaves,
                    const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
                    const RecoveryInputs& inputs) {
  const std::size_t n = present.entries.size();
  RecoveredSet out;
  out.particles.resize(n);
  out.graphs.resize(n);
  out.contradiction.resize(n);
  inputs.parallel.forEach(n, [&](std::size_t e) {
    if (!leaves[e]) {
      out.particles[e] = particles[e];
      out.graphs[e] = graphs[e];
      return;
    }
    const SavedEntry& entry = present.entries[e];
    const grid::OccupancyGrid map = mapAtTe(entry, inputs.shapes);
    out.particles[e] = attach(entry, map, leaves[e], inputs.shapes, inputs.checkpoint_updates);
    out.graphs[e] = entry.graph;
    out.graphs[e].attach(graphs[e], positionsAfter(leaves[e], present.te));
  });
  for (std::size_t e = 0; e < n; ++e) {
    out.weights.push_back(present.entries[e].weight);
    out.sources.push_back(e);
  }
  return out;
}

}  // namespace ariadne::loops
