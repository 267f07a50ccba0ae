// Predict, match and weigh: the sampling and importance weighting of the paper's Section III, with
// the improved proposal of Grisetti, Stachniss and Burgard (models/proposal.h).
#include <cmath>
#include <numeric>

#include "ariadne/filter/particle_set.h"
#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::filter {

using mrpt::math::TPose2D;

namespace {

/// A motion that no scan checks drifts by more than the noise of its steps, since wheels are not as
/// round and as large as they are told: variances of (x, y, heading) per metre.
Eigen::Matrix3d uncheckedDriftPerMetre() {
  const double turn = 0.3 * M_PI / 180;
  return Eigen::Vector3d(0.03, 0.015, turn).cwiseAbs2().asDiagonal();
}

/// The last metres of s* confirm a match that is off the odometry when they place the robot off it,
/// too, by more than this share. Of 435 disputed matches on MRPT's sample, 434 had over 0.9 and all
/// stayed; of 451 on a drive of the Infinite Corridor, 339 had under 0.5, 65 over 0.8.
constexpr double kSlipped = 0.8;

}  // namespace

void ParticleSet::predict(const TPose2D& increment) {
  increment_ = increment;
  if (models_.motion.learn)
    predictBy({learner_.corrected(increment), learner_.params()});
  else
    predictBy({increment, models_.motion});
}

void ParticleSet::predict(const TPose2D& increment, const Eigen::Matrix3d& covariance) {
  increment_ = increment;
  predictBy({increment, covariance});
}

void ParticleSet::predictBy(const models::Motion& motion) {
  motion_ = motion;
  figures_ = {};
  candidates_.assign(size(), {});
  for (std::size_t i = 0; i < size(); ++i) {
    const TPose2D& before = (*this)[i].map_from_robot;
    candidates_[i].prior = {motion.mean(before), motion.covariance(before)};
    candidates_[i].match.map_from_robot = candidates_[i].prior.mean;
  }
}

void ParticleSet::match(const grid::Scan& scan) {
  if (!matches()) return;
  parallel_.forEach(size(), [&](std::size_t i) {
    const models::PosePrior& prior = candidates_[i].prior;
    candidates_[i].match = matcher_((*this)[i].map, scan.features, prior.mean, prior.covariance);
  });
  settleDisputes(scan);
  if (scan.walls.across < models_.matcher.blind_share)
    for (Candidate& c : candidates_) leaveToOdometry(scan.walls.axis, c);
}

/// Where a match is far off the odometry, the last metres of the hypothesis are asked. A map of
/// them for each hypothesis is dear: where those of s* say that the wheels slipped, none is made.
void ParticleSet::settleDisputes(const grid::Scan& scan) {
  std::vector<std::size_t> disputed;
  for (std::size_t i = 0; i < size(); ++i)
    if (recent_.dispute(candidates_[i].match, candidates_[i].prior)) disputed.push_back(i);
  if (disputed.empty()) return;
  const auto recent = [&](std::size_t i) {
    return recent_.matched(candidates_[i].prior, matcher_, scan.features, (*this)[i].ancestor);
  };
  const std::size_t star = best();
  const models::Match of_star = recent(star);
  const double slip = sigmasOff(of_star.map_from_robot, candidates_[star].prior);
  parallel_.forEach(disputed.size(), [&](std::size_t k) {
    Candidate& c = candidates_[disputed[k]];
    if (slip > kSlipped * sigmasOff(c.match.map_from_robot, c.prior)) return;
    const models::Match own = disputed[k] == star ? of_star : recent(disputed[k]);
    c.match = RecentScans::settled(c.match, own, c.prior);
  });
}

/// In a bare corridor the ends of beams go along with the robot, and the walls as mapped hold it
/// back: 2 to 3 % of the way. What the scan cannot tell is not asked of it.
void ParticleSet::leaveToOdometry(const mrpt::math::TPoint2D& axis, Candidate& c) const {
  TPose2D& at = c.match.map_from_robot;
  const Eigen::Vector2d along = Eigen::Rotation2Dd(at.phi) * Eigen::Vector2d(axis.x, axis.y);
  const double off_m = along.dot(Eigen::Vector2d(at.x - c.prior.mean.x, at.y - c.prior.mean.y));
  at.x -= off_m * along.x();
  at.y -= off_m * along.y();
  c.told.topLeftCorner<2, 2>() -= along * along.transpose();
}

void ParticleSet::weigh(const grid::Scan& scan) {
  figures_.evidence = evidenceOfPlace();
  parallel_.forEach(size(), [&](std::size_t i) { draw(i, scan); });
  learnMotion(candidates_[best()]);
  for (std::size_t i = 0; i < size(); ++i) {
    const Candidate& c = candidates_[i];
    const double log_increment = figures_.evidence * c.log_weight;
    Particle& particle = m_particles[i].d;
    m_particles[i].log_w += log_increment;
    particle.map_from_robot = c.pose;
    particle.ancestor =
        std::make_shared<Ancestor>(std::move(particle.ancestor), step_, c.pose, log_increment);
    figures_.matches_accepted += c.match.accepted;
  }
  const std::vector<double> w = weights();
  for (std::size_t i = 0; i < size(); ++i)
    figures_.log_likelihood += w[i] * candidates_[i].log_likelihood;
  normalizeWeights();
  parents_.resize(size());
  std::iota(parents_.begin(), parents_.end(), 0);
  twin_ = parents_;
}

/// The particle's pose from its proposal, and its weight there.
void ParticleSet::draw(std::size_t i, const grid::Scan& scan) {
  const Particle& particle = (*this)[i];
  const FilterParams& p = models_.filter;
  Candidate& c = candidates_[i];
  const auto stream = [&](core::Purpose purpose) {
    return core::RandomStream(p.seed, static_cast<std::uint32_t>(step_),
                              static_cast<std::uint32_t>(i), purpose);
  };
  if (!map_is_known_) {
    c.pose = c.prior.mean;
    return;
  }
  if (p.proposal == Proposal::improved) {
    const models::PoseGaussian fit =
        models::fitProposal(likelihood_, particle.map, scan.features, c.match.map_from_robot,
                            c.prior, {p.proposal_gain, p.weight_gain}, c.told);
    auto rng = stream(core::Purpose::proposal);
    c.pose = fit.sample(rng);
    c.information = fit.information;
    c.log_likelihood = fit.log_likelihood;
    c.log_weight = fit.log_weight;
    return;
  }
  if (p.proposal == Proposal::odometry) {
    auto rng = stream(core::Purpose::motion);
    c.pose = motion_->sample(particle.map_from_robot, rng);
  } else {
    c.pose = c.match.map_from_robot;
  }
  c.log_likelihood = likelihood_(particle.map, scan.features, c.pose);
  c.log_weight = p.weight_gain * c.log_likelihood;
}

double ParticleSet::evidenceOfPlace() const {
  const FilterParams& p = models_.filter;
  if (p.revisit_exponent == 0 && p.new_ground_weight == 1) return 1;
  const std::size_t passes = earlierPasses((*this)[best()].ancestor, p.revisit_radius_m);
  if (passes == 0) return p.new_ground_weight;
  return std::pow(static_cast<double>(passes), -p.revisit_exponent);
}

/// What the step of s* tells about the odometry, and how well the step is known.
void ParticleSet::learnMotion(const Candidate& star) {
  const TPose2D before = (*this)[best()].map_from_robot;
  const Eigen::Matrix3d covariance =
      (star.prior.covariance.inverse() + models::kCalibratedGain * star.information).inverse();
  const Eigen::Matrix3d to_robot = geometry::turnedBy(-before.phi);
  figures_.motion_covariance = to_robot * covariance * to_robot.transpose();
  if (star.information.isZero(0))
    figures_.motion_covariance += std::hypot(increment_.x, increment_.y) * uncheckedDriftPerMetre();
  if (models_.motion.learn && star.match.accepted && !motion_->isGiven())
    learner_.add(increment_, geometry::relativePose(before, star.match.map_from_robot), before,
                 star.information, models_.filter.proposal_gain);
}

}  // namespace ariadne::filter
