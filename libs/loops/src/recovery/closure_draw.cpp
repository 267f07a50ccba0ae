#include "closure_draw.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::loops {
namespace {

/// A line with other poses after te; what the filter weighed stays, and the closure's density comes
/// to it.
filter::AncestorPtr lineWith(const filter::AncestorPtr& leaf, std::size_t te,
                             const std::vector<mrpt::math::TPose2D>& poses, double log_density) {
  std::vector<const filter::Ancestor*> nodes;
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    if (a.step() <= te) return false;
    nodes.push_back(&a);
    return true;
  });
  std::reverse(nodes.begin(), nodes.end());
  filter::AncestorPtr out = filter::ancestorAt(leaf, te);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    out = std::make_shared<filter::Ancestor>(
        out, nodes[k]->step(), poses[k],
        nodes[k]->logWeight() + (k + 1 == nodes.size() ? log_density : 0), nodes[k]->motion());
  return out;
}

/// Within what the matcher and the weights settle by themselves.
bool closed(const mrpt::math::TPose2D& off) {
  return std::hypot(off.x, off.y) < 0.2 && std::abs(off.phi) < 0.03;
}

}  // namespace

RecoveredSet drawGiven(const Closure& found, const Finder& finder, const SavedSet& present,
                       const filter::ParticleSet& particles, const std::vector<PlaceGraph>& graphs,
                       const RecoveryInputs& inputs) {
  const std::size_t n = particles.size();
  std::vector<filter::AncestorPtr> leaves(n);
  std::vector<double> log_density(n);
  const std::size_t star = particles.best();
  inputs.parallel.forEach(n, [&](std::size_t i) {
    const Track track = finder.trackOf(particles[i].ancestor);
    std::vector<Tie> ties = tiesOf(track, finder.contacts());
    const auto off = geometry::relativePose(
        geometry::compose(track.poses[found.anchor], found.anchor_from_robot), track.poses.back());
    ties.push_back({found.anchor, track.now(), found.anchor_from_robot, found.information, false});
    core::RandomStream rng(inputs.seed, static_cast<std::uint32_t>(particles.step()),
                           static_cast<std::uint32_t>(i), core::Purpose::closure);
    // s* takes the most probable path and the others a sample: of a Gaussian, a sample's squared
    // error is twice the mean's, and s* is what the robot goes by.
    const auto sample =
        drawSegment(track, found.begin, ties, closed(off) || i == star ? nullptr : &rng);
    log_density[i] = -sample.cost;
    if (!closed(off))
      leaves[i] = lineWith(particles[i].ancestor, found.begin, sample.poses, -sample.cost);
  });
  RecoveredSet set = redraw(present, leaves, particles, graphs, inputs);
  const double best = *std::max_element(log_density.begin(), log_density.end());
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += set.weights[i] *= std::exp(log_density[i] - best);
  for (double& w : set.weights) w /= sum;
  return set;
}

}  // namespace ariadne::loops
