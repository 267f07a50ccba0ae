#include "attach.h"

#include <algorithm>

namespace ariadne::loops {
namespace {

using filter::Ancestor;

/// Nodes of the updates after `step`, in the order of time.
std::vector<const Ancestor*> nodesAfter(const filter::AncestorPtr& leaf, std::size_t step) {
  std::vector<const Ancestor*> nodes;
  filter::forEachAncestor(leaf, [&](const Ancestor& a) {
    if (a.step() <= step) return false;
    nodes.push_back(&a);
    return true;
  });
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

grid::OccupancyGrid mapAtTe(const SavedEntry& entry, const std::vector<grid::ScanShape>& shapes) {
  grid::OccupancyGrid map = entry.checkpoint->map;
  std::vector<grid::PlacedScan> scans;
  for (const Ancestor* a : nodesAfter(entry.at_te, entry.checkpoint->step))
    scans.push_back({&shapes[a->step()], a->pose()});
  map.insertMany(scans);
  return map;
}

filter::Particle attach(const SavedEntry& entry, const grid::OccupancyGrid& map_at_te,
                        const filter::AncestorPtr& leaf, const std::vector<grid::ScanShape>& shapes,
                        std::size_t checkpoint_updates) {
  filter::Particle p;
  p.ancestor = leaf;
  p.checkpoints = entry.checkpoint;
  p.map = map_at_te;
  std::vector<grid::PlacedScan> scans;  // not inserted yet
  for (const Ancestor* a : nodesAfter(leaf, entry.at_te->step())) {
    scans.push_back({&shapes[a->step()], a->pose()});
    if (a->step() % checkpoint_updates != 0) continue;
    p.map.insertMany(scans);
    scans.clear();
    p.checkpoints = std::make_shared<filter::Checkpoint>(a->step(), p.map, p.checkpoints);
  }
  p.map.insertMany(scans);
  p.map_from_robot = leaf->pose();
  return p;
}

double contradiction(const grid::OccupancyGrid& map_at_te, const filter::AncestorPtr& leaf,
                     std::size_t te, const std::vector<grid::ScanShape>& shapes) {
  constexpr std::size_t kStride = 4;
  std::size_t known = 0;
  std::size_t contradicting = 0;
  for (const Ancestor* a : nodesAfter(leaf, te)) {
    if (a->step() % kStride != 0) continue;
    const auto& hits = shapes[a->step()].hits;
    const double c = std::cos(a->pose().phi);
    const double s = std::sin(a->pose().phi);
    for (std::size_t i = 0; i < hits.size(); i += kStride) {
      const grid::Cell cell = map_at_te.cellOf({a->pose().x + c * hits[i].x - s * hits[i].y,
                                                a->pose().y + s * hits[i].x + c * hits[i].y});
      if (map_at_te.at(cell) == 0) continue;
      ++known;
      contradicting += map_at_te.at(cell) == grid::kMostFree && map_at_te.fieldAt(cell) == 0;
    }
  }
  return known == 0 ? 0 : static_cast<double>(contradicting) / static_cast<double>(known);
}

}  // namespace ariadne::loops
