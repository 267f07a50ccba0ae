#include "drawn_parts.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::report {
namespace {

using mrpt::math::TPoint2Df;

TPoint2Df asFloats(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

}  // namespace

std::vector<ReplayParticle> drawnParticles(const FilterView& view, std::size_t most) {
  const std::size_t every = (view.particles.size() + most - 1) / most;
  std::vector<ReplayParticle> drawn;
  for (std::size_t i = 0; i < view.particles.size(); i += every)
    drawn.push_back({view.particles[i]->map_from_robot, view.weights[i]});
  return drawn;
}

std::vector<TPoint2Df> drawnPath(const filter::AncestorPtr& leaf, double spacing_m) {
  std::vector<TPoint2Df> line;
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    line.push_back(asFloats(a.pose().x, a.pose().y));
    return true;
  });
  std::reverse(line.begin(), line.end());
  std::vector<TPoint2Df> kept;
  for (const TPoint2Df& p : line)
    if (kept.empty() || geometry::distance(p, kept.back()) >= spacing_m) kept.push_back(p);
  if (!line.empty() && kept.back() != line.back()) kept.push_back(line.back());
  return kept;
}

ReplayGraph drawnGraph(const loops::PlaceGraph& graph) {
  ReplayGraph drawn;
  drawn.places.reserve(graph.places().size());
  drawn.edges.reserve(graph.edges().size());
  graph.places().forEach(
      [&](const loops::Place& p) { drawn.places.push_back(asFloats(p.position.x, p.position.y)); });
  graph.edges().forEach([&](const loops::Edge& e) { drawn.edges.emplace_back(e.a, e.b); });
  return drawn;
}

}  // namespace ariadne::report
