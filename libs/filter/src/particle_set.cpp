#include "ariadne/filter/particle_set.h"

#include <algorithm>
#include <cmath>

#include "ariadne/core/random.h"
#include "ariadne/filter/resampling.h"

namespace ariadne::filter {

ParticleSet::ParticleSet(const FilterModels& models, const core::Parallel& parallel,
                         const mrpt::math::TPose2D& start, const grid::OccupancyGrid& map)
    : models_(models),
      parallel_(parallel),
      likelihood_(models.likelihood, models.grid.field_sigma_m),
      matcher_(models.matcher, models.filter.proposal_gain),
      learner_(models.motion),
      recent_(models.grid, models.matcher.disputed_sigmas),
      map_is_known_(!map.knownBox().empty()) {
  CParticleData first;
  first.log_w = 0;
  first.d.map_from_robot = start;
  first.d.map = map;
  m_particles.assign(static_cast<std::size_t>(models.filter.particles), first);
}

std::size_t ParticleSet::best() const {
  // Eq. (8)
  const auto it = std::max_element(
      m_particles.begin(), m_particles.end(),
      [](const auto& a, const auto& b) { return a.d.accumulated() < b.d.accumulated(); });
  return static_cast<std::size_t>(it - m_particles.begin());
}

std::vector<double> ParticleSet::weights() const {
  std::vector<double> logs;
  for (const auto& p : m_particles) logs.push_back(p.log_w);
  std::vector<double> weights;
  log2linearWeights(logs, weights);
  return weights;
}

geometry::WeightedPoses ParticleSet::poses() const {
  geometry::WeightedPoses set;
  set.weights = weights();
  for (const auto& p : m_particles) set.poses.push_back(p.d.map_from_robot);
  return set;
}

void ParticleSet::resample() {
  core::RandomStream rng(models_.filter.seed, static_cast<std::uint32_t>(step_), 0,
                         core::Purpose::resampling);
  std::vector<double> logs;
  for (const auto& p : m_particles) logs.push_back(p.log_w);
  performSubstitution(drawByWeight(models_.filter.resampling, logs, rng));
}

void ParticleSet::performSubstitution(const std::vector<size_t>& drawn) {
  CParticleList next;
  std::vector<std::size_t> first_child(size(), drawn.size());
  twin_.clear();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    next.push_back(m_particles[drawn[i]]);
    next.back().log_w = 0;
    first_child[drawn[i]] = std::min(first_child[drawn[i]], i);
    twin_.push_back(first_child[drawn[i]]);
  }
  m_particles = std::move(next);
  parents_ = drawn;
  figures_.resampled = true;
}

void ParticleSet::replace(std::vector<Particle> particles, const std::vector<double>& weights) {
  ASSERT_EQUAL_(particles.size(), weights.size());
  m_particles.resize(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    m_particles[i].d = std::move(particles[i]);
    m_particles[i].log_w = std::log(weights[i]);
  }
}

void ParticleSet::insert(const grid::Scan& scan, std::size_t checkpoint_updates) {
  recent_.add(step_, scan.shape, std::hypot(increment_.x, increment_.y));
  const bool keep = step_ % checkpoint_updates == 0;
  // Children of one parent are still the same hypothesis: its map is changed once, then shared.
  parallel_.forEach(size(), [&](std::size_t i) {
    if (twin_[i] != i) return;
    Particle& p = m_particles[i].d;
    p.map.insert(scan.shape, p.map_from_robot);
    if (keep) p.checkpoints = std::make_shared<Checkpoint>(step_, p.map, p.checkpoints);
  });
  for (std::size_t i = 0; i < size(); ++i)
    if (twin_[i] != i) m_particles[i].d = m_particles[twin_[i]].d;
  map_is_known_ = true;
  ++step_;
}

}  // namespace ariadne::filter
