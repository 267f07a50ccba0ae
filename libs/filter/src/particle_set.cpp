#include "ariadne/filter/particle_set.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ariadne/filter/residual.h"
#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::filter {

using mrpt::bayes::CParticleFilter;

CParticleFilter::TParticleFilterOptions particleFilterOptions(const FilterParams& p) {
  CParticleFilter::TParticleFilterOptions options;
  options.adaptiveSampleSize = false;
  options.BETA = p.beta;
  options.sampleSize = static_cast<unsigned>(p.particles);
  options.powFactor = p.weight_gain;
  options.PF_algorithm = p.proposal == Proposal::odometry ? CParticleFilter::pfStandardProposal
                                                          : CParticleFilter::pfOptimalProposal;
  switch (p.resampling) {
    case Resampling::multinomial:
      options.resamplingMethod = CParticleFilter::prMultinomial;
      break;
    case Resampling::residual:
      options.resamplingMethod = CParticleFilter::prResidual;
      break;
    case Resampling::stratified:
      options.resamplingMethod = CParticleFilter::prStratified;
      break;
    case Resampling::systematic:
      options.resamplingMethod = CParticleFilter::prSystematic;
      break;
  }
  return options;
}

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

void ParticleSet::prediction_and_update_pfStandardProposal(
    const mrpt::obs::CActionCollection* action, const mrpt::obs::CSensoryFrame* observation,
    const CParticleFilter::TParticleFilterOptions&) {
  predictMatchWeigh(action, observation);
}

void ParticleSet::prediction_and_update_pfOptimalProposal(
    const mrpt::obs::CActionCollection* action, const mrpt::obs::CSensoryFrame* observation,
    const CParticleFilter::TParticleFilterOptions&) {
  predictMatchWeigh(action, observation);
}

double ParticleSet::evidenceOfPlace() const {
  const FilterParams& p = models_.filter;
  if (p.revisit_exponent == 0 && p.new_ground_weight == 1) return 1;
  const std::size_t passes = earlierPasses((*this)[best()].ancestor, p.revisit_radius_m);
  if (passes == 0) return p.new_ground_weight;
  return std::pow(static_cast<double>(passes), -p.revisit_exponent);
}

/// With the action's own covariance where it has one: more than the odometry's noise is in it then,
/// and nothing is to be learned from it.
models::Motion ParticleSet::motionOf(const mrpt::obs::CActionRobotMovement2D& movement) const {
  const auto [covariance, mean] = movement.poseChange->getCovarianceAndMean();
  const Eigen::Matrix3d given = covariance.asEigen();
  if (!given.isZero(0)) return {mean.asTPose(), given};
  if (!models_.motion.learn) return {mean.asTPose(), models_.motion};
  return {learner_.corrected(mean.asTPose()), learner_.params()};
}

void ParticleSet::predictMatchWeigh(const mrpt::obs::CActionCollection* action,
                                    const mrpt::obs::CSensoryFrame* observation) {
  ASSERT_(action && observation);
  const auto scan = observation->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
  const auto movement = action->getActionByClass<mrpt::obs::CActionRobotMovement2D>();
  ASSERT_(scan && movement);
  const mrpt::math::TPose2D increment = movement->poseChange->getMeanVal().asTPose();
  const models::Motion motion = motionOf(*movement);
  points_ = grid::thinned(grid::scanFeatures(*scan, models_.grid.insert_range_m),
                          static_cast<std::size_t>(models_.matcher.max_beams));
  shape_ = grid::makeScanShape(*scan, models_.grid);
  travelled_m_ = std::hypot(increment.x, increment.y);
  figures_ = {};
  figures_.evidence = evidenceOfPlace();

  std::vector<Outcome> outcomes(size());
  parallel_.forEach(size(), [&](std::size_t i) { outcomes[i] = propose(i, motion); });
  judgeMotion(increment, motion, outcomes[best()]);

  for (std::size_t i = 0; i < size(); ++i) {
    const double log_increment = figures_.evidence * outcomes[i].log_weight;
    Particle& particle = m_particles[i].d;
    m_particles[i].log_w += log_increment;
    particle.map_from_robot = outcomes[i].pose;
    particle.ancestor = std::make_shared<Ancestor>(std::move(particle.ancestor), step_,
                                                   outcomes[i].pose, log_increment);
    figures_.matches_accepted += outcomes[i].match_accepted;
  }
  const std::vector<double> w = weights();
  for (std::size_t i = 0; i < size(); ++i)
    figures_.log_likelihood += w[i] * outcomes[i].log_likelihood;
  parents_.resize(size());
  std::iota(parents_.begin(), parents_.end(), 0);
  twin_ = parents_;
}

namespace {

/// A way that no scan checks drifts by more than the noise of its steps, since wheels are not as
/// round and as large as they are told: variances of (x, y, heading) per metre.
Eigen::Matrix3d uncheckedDriftPerMetre() {
  const double turn = 0.3 * M_PI / 180;
  return Eigen::Vector3d(0.03, 0.015, turn).cwiseAbs2().asDiagonal();
}

}  // namespace

/// What the step of s* tells about the odometry, and how well the step is known.
void ParticleSet::judgeMotion(const mrpt::math::TPose2D& increment, const models::Motion& motion,
                              const Outcome& star) {
  const mrpt::math::TPose2D before = (*this)[best()].map_from_robot;
  const Eigen::Matrix3d covariance =
      (motion.covariance(before).inverse() + models::kCalibratedGain * star.information).inverse();
  const Eigen::Matrix3d to_robot = geometry::turnedBy(-before.phi);
  figures_.motion_covariance = to_robot * covariance * to_robot.transpose();
  if (star.information.isZero(0))
    figures_.motion_covariance += std::hypot(increment.x, increment.y) * uncheckedDriftPerMetre();
  if (models_.motion.learn && star.match_accepted && !motion.isGiven())
    learner_.add(increment, geometry::relativePose(before, star.match), before, star.information,
                 models_.filter.proposal_gain);
}

ParticleSet::Outcome ParticleSet::propose(std::size_t i, const models::Motion& motion) const {
  const Particle& particle = (*this)[i];
  const FilterParams& p = models_.filter;
  const auto stream = [&](core::Purpose purpose) {
    return core::RandomStream(p.seed, static_cast<std::uint32_t>(step_),
                              static_cast<std::uint32_t>(i), purpose);
  };
  Outcome out;
  const models::PosePrior prior{motion.mean(particle.map_from_robot),
                                motion.covariance(particle.map_from_robot)};
  if (!map_is_known_) {
    out.pose = prior.mean;
    return out;
  }
  if (p.proposal == Proposal::odometry) {
    auto rng = stream(core::Purpose::motion);
    out.pose = motion.sample(particle.map_from_robot, rng);
    out.log_likelihood = likelihood_(particle.map, points_, out.pose);
    out.log_weight = p.weight_gain * out.log_likelihood;
    return out;
  }
  const models::Match match =
      recent_.settled(matcher_(particle.map, points_, prior.mean, prior.covariance), prior,
                      matcher_, points_, particle.ancestor);
  out.match_accepted = match.accepted;
  if (p.proposal == Proposal::scan_match) {
    out.pose = match.map_from_robot;
    out.log_likelihood = likelihood_(particle.map, points_, out.pose);
    out.log_weight = p.weight_gain * out.log_likelihood;
    return out;
  }
  const models::PoseGaussian fit =
      models::fitProposal(likelihood_, particle.map, points_, match.map_from_robot, prior,
                          {p.proposal_gain, p.weight_gain});
  auto rng = stream(core::Purpose::proposal);
  out.pose = fit.sample(rng);
  out.match = match.map_from_robot;
  out.information = fit.information;
  out.log_likelihood = fit.log_likelihood;
  out.log_weight = fit.log_weight;
  return out;
}

void ParticleSet::performSubstitution(const std::vector<size_t>& drawn) {
  std::vector<size_t> indices = drawn;
  if (models_.filter.resampling == Resampling::residual) {
    core::RandomStream rng(models_.filter.seed, static_cast<std::uint32_t>(step_), 0,
                           core::Purpose::resampling);
    indices = residualIndices(weights(), rng);
  }
  CParticleList next;
  std::vector<std::size_t> first_child(size(), indices.size());
  twin_.clear();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    next.push_back(m_particles[indices[i]]);
    next.back().log_w = 0;  // MRPT's performResampling leaves them when the count stays the same
    first_child[indices[i]] = std::min(first_child[indices[i]], i);
    twin_.push_back(first_child[indices[i]]);
  }
  m_particles = std::move(next);
  parents_ = std::move(indices);
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

void ParticleSet::insertScan(std::size_t checkpoint_updates) {
  recent_.add(step_, shape_, travelled_m_);
  const bool keep = step_ % checkpoint_updates == 0;
  // Children of one parent are still the same hypothesis: its map is changed once, then shared.
  parallel_.forEach(size(), [&](std::size_t i) {
    if (twin_[i] != i) return;
    Particle& p = m_particles[i].d;
    p.map.insert(shape_, p.map_from_robot);
    if (keep) p.checkpoints = std::make_shared<Checkpoint>(step_, p.map, p.checkpoints);
  });
  for (std::size_t i = 0; i < size(); ++i)
    if (twin_[i] != i) m_particles[i].d = m_particles[twin_[i]].d;
  map_is_known_ = true;
  ++step_;
}

}  // namespace ariadne::filter
