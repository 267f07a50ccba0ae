// The particle set, and what an update does to it. In this order (slam/src/mapper.cpp): predict,
// match, weigh, Neff, resample, insert. It is a CParticleFilterCapable of mrpt::bayes, whose
// weights, Neff and resampling it uses; CParticleFilter::executeOn is what slam::Mapper spells out.
#pragma once
#include <mrpt/bayes/CParticleFilterCapable.h>
#include <mrpt/bayes/CParticleFilterData.h>

#include <optional>
#include <vector>

#include "ariadne/core/parallel.h"
#include "ariadne/filter/params.h"
#include "ariadne/filter/particle.h"
#include "ariadne/filter/recent_scans.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/grid/insertion/scan.h"
#include "ariadne/models/motion_learner.h"
#include "ariadne/models/motion_model.h"
#include "ariadne/models/proposal.h"
#include "ariadne/models/scan_matcher.h"

namespace ariadne::filter {

/// Everything about particles that does not change during a run.
struct FilterModels {
  FilterParams filter;
  models::MotionParams motion;
  models::MatcherParams matcher;
  grid::GridParams grid;
  grid::LikelihoodParams likelihood;
};

/// The particles of a Rao-Blackwellized filter (Doucet et al. 2000), driven by mrpt::bayes: each
/// has a path, a map of its own and a weight.
class ParticleSet
    : public mrpt::bayes::CParticleFilterData<Particle, mrpt::bayes::particle_storage_mode::VALUE>,
      public mrpt::bayes::CParticleFilterDataImpl<
          ParticleSet, mrpt::bayes::CParticleFilterData<
                           Particle, mrpt::bayes::particle_storage_mode::VALUE>::CParticleList> {
 public:
  /// All particles at `start` with a copy of `map`. `parallel` must outlive the set.
  ParticleSet(const FilterModels& models, const core::Parallel& parallel,
              const mrpt::math::TPose2D& start, const grid::OccupancyGrid& map);

  /// Number of particles, N.
  std::size_t size() const { return m_particles.size(); }
  /// i in [0, size()).
  const Particle& operator[](std::size_t i) const { return m_particles[i].d; }
  /// s* of Eq. (8): the largest accumulated weight, ties to the lowest index.
  std::size_t best() const;
  /// Normalised weights, summing to 1.
  std::vector<double> weights() const;

  /// map_from_robot of all particles, with their normalised weights.
  geometry::WeightedPoses poses() const;

  /// Puts other hypotheses in the place of these, as recovery does.
  /// @param weights one a particle, sum 1
  void replace(std::vector<Particle> particles, const std::vector<double>& weights);

  /// What is drawn from now on comes from this seed.
  void reseed(std::uint64_t seed) { models_.filter.seed = seed; }

  /// What was learned of the odometry so far.
  const models::MotionLearner& learned() const { return learner_; }

  /// Number of the update that runs next; keys the random streams.
  std::size_t step() const { return step_; }

  /// p(x_t | x_{t-1}, u_t) of each particle, by the motion model and what was learned of it.
  /// @param increment of the odometry since the last update, m and rad, in the frame before it
  void predict(const mrpt::math::TPose2D& increment);
  /// The same for a motion that is known otherwise, of which nothing is learned.
  /// @param covariance of (x, y, heading) in the frame before the motion
  void predict(const mrpt::math::TPose2D& increment, const Eigen::Matrix3d& covariance);
  /// Finds where the scan fits each particle's map best about its prediction ([filter] proposal
  /// odometry: nowhere).
  void match(const grid::Scan& scan);
  /// Draws each particle's pose from the proposal about its match, and multiplies its weight by how
  /// probable the scan is.
  void weigh(const grid::Scan& scan);
  /// Eq. (10): 1 / sum of squared normalised weights.
  double neff() const { return ESS() * static_cast<double>(size()); }
  /// Draws as many particles as there are, by weight ([filter] resampling); all weigh the same
  /// then.
  void resample();
  /// Inserts the scan into every particle's map (children of one parent share the work) and ends
  /// the update. A checkpoint is kept each `checkpoint_updates`.
  void insert(const grid::Scan& scan, std::size_t checkpoint_updates);

  /// Index, before the resampling of the last update, of each particle's parent; its own where
  /// there was none.
  const std::vector<std::size_t>& parents() const { return parents_; }

  /// Figures of the update in progress.
  struct Figures {
    std::size_t matches_accepted = 0;
    double log_likelihood = 0;  ///< mean by weight, untempered
    double evidence = 1;        ///< factor on this step's log weights: new ground, revisits
    bool resampled = false;
    /// Of the motion of s* given odometry and scan: (x, y, heading) in the frame before it. The
    /// odometry's own, and the drift of wheels, where no scan was matched.
    Eigen::Matrix3d motion_covariance = Eigen::Matrix3d::Zero();
  };
  /// Of the last update.
  const Figures& figures() const { return figures_; }

  /// Of mrpt::bayes::CParticleFilterCapable: particle i becomes a child of the one drawn[i].
  void performSubstitution(const std::vector<size_t>& drawn) override;

 private:
  /// What an update finds for one particle.
  struct Candidate {
    models::PosePrior prior;
    models::Match match;                                 // accepted: a scan fitted there
    Eigen::Matrix3d told = Eigen::Matrix3d::Identity();  // onto what the scan tells of, map frame
    mrpt::math::TPose2D pose;
    double log_weight = 0;
    double log_likelihood = 0;
    Eigen::Matrix3d information =
        Eigen::Matrix3d::Zero();  // of the scan at the match; zero when not fitted
  };
  void predictBy(const models::Motion& motion);
  void settleDisputes(const grid::Scan& scan);
  void leaveToOdometry(const mrpt::math::TPoint2D& axis, Candidate& candidate) const;
  void draw(std::size_t i, const grid::Scan& scan);
  void learnMotion(const Candidate& star);
  double evidenceOfPlace() const;
  bool matches() const { return map_is_known_ && models_.filter.proposal != Proposal::odometry; }

  FilterModels models_;
  const core::Parallel& parallel_;
  grid::EndpointLikelihood likelihood_;
  models::ScanMatcher matcher_;
  models::MotionLearner learner_;
  RecentScans recent_;
  mrpt::math::TPose2D increment_;  // of the update in progress, as the next two
  std::optional<models::Motion> motion_;
  std::vector<Candidate> candidates_;
  std::size_t step_ = 0;
  bool map_is_known_;  // something to match against
  Figures figures_;
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> twin_;  // lowest index with the same parent in this update
};

}  // namespace ariadne::filter
