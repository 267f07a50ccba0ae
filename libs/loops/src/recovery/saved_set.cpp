#include "ariadne/loops/recovery/saved_set.h"

#include <set>
#include <stdexcept>
#include <unordered_set>

namespace ariadne::loops {

std::size_t SavedSet::distinctAncestors() const {
  std::set<const filter::Ancestor*> distinct;
  for (const SavedEntry& e : entries) distinct.insert(e.at_te.get());
  return distinct.size();
}

std::size_t SavedSet::mapBytes() const {
  std::unordered_set<const void*> tiles;
  std::size_t bytes = 0;
  std::unordered_set<const filter::Checkpoint*> seen;
  const auto count = [&](const auto& tile, std::size_t size) {
    if (tiles.insert(&tile).second) bytes += size;
  };
  for (const SavedEntry& e : entries) {
    if (!e.checkpoint || !seen.insert(e.checkpoint.get()).second) continue;
    const grid::OccupancyGrid& map = e.checkpoint->map;
    map.cells().forEachPacked([&](int, int, const auto& tile) { count(tile, tile.bytes()); });
    map.field().forEachTile([&](int, int, const auto& tile) { count(tile, sizeof(tile)); });
  }
  return bytes;
}

SavedSet save(const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
              std::size_t te) {
  if (te + 1 > particles.step()) throw std::out_of_range("loops::save: te is not past");
  SavedSet set;
  set.te = te;
  set.saving = particles.step() - 1;
  const std::vector<double> weights = particles.weights();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const filter::Particle& p = particles[i];
    std::shared_ptr<const filter::Checkpoint> checkpoint = p.checkpoints;
    while (checkpoint && checkpoint->step > te) checkpoint = checkpoint->earlier;
    // Eq. (11) and Eq. (12)
    set.entries.push_back({filter::ancestorAt(p.ancestor, te), p.ancestor, checkpoint, weights[i],
                           graphs[i].asOf(te)});
  }
  return set;
}

}  // namespace ariadne::loops
