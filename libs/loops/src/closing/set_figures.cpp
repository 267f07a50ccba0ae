#include "set_figures.h"

#include <cmath>

namespace ariadne::loops {

std::vector<filter::AncestorPtr> leavesOf(const filter::ParticleSet& particles) {
  std::vector<filter::AncestorPtr> leaves;
  for (std::size_t i = 0; i < particles.size(); ++i) leaves.push_back(particles[i].ancestor);
  return leaves;
}

geometry::WeightedPoses posesOf(const SavedSet& saved) {
  geometry::WeightedPoses set;
  for (const SavedEntry& e : saved.entries) {
    set.poses.push_back(e.at_te->pose());
    set.weights.push_back(e.weight);
  }
  return set;
}

double spreadOf(const geometry::WeightedPoses& set) {
  double x = 0;
  double y = 0;
  for (std::size_t i = 0; i < set.poses.size(); ++i) {
    x += set.weights[i] * set.poses[i].x;
    y += set.weights[i] * set.poses[i].y;
  }
  double sum = 0;
  for (std::size_t i = 0; i < set.poses.size(); ++i)
    sum += set.weights[i] * (std::pow(set.poses[i].x - x, 2) + std::pow(set.poses[i].y - y, 2));
  return std::sqrt(sum);
}

}  // namespace ariadne::loops
