#include "ariadne/eval/entropy.h"

namespace ariadne::eval {

Entropy entropyOf(const std::vector<const filter::Particle*>& particles,
                  const std::vector<double>& weights, const CountedCells& cells,
                  const EntropyFloor& floor) {
  geometry::checkCounts(weights.size(), particles.size(), "particles");
  geometry::WeightedPoses now;
  now.weights = weights;
  std::vector<filter::AncestorPtr> leaves;
  std::vector<const grid::OccupancyGrid*> maps;
  for (const filter::Particle* p : particles) {
    now.poses.push_back(p->map_from_robot);
    leaves.push_back(p->ancestor);
    maps.push_back(&p->map);
  }
  Entropy entropy;
  entropy.pose = gaussianEntropy(now, floor);
  entropy.path = pathEntropy(leaves, weights, floor);
  const auto of_maps = mapEntropies(maps, cells);
  for (std::size_t i = 0; i < maps.size(); ++i) entropy.map += weights[i] * of_maps[i];
  return entropy;
}

}  // namespace ariadne::eval
