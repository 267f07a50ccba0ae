// The particle set, as mrpt::bayes::CParticleFilter drives it: predict, match and weigh behind
// MRPT's prediction_and_update, resampling behind performSubstitution. An action whose motion has a
// covariance is taken at its word; without one, the noise is that of the motion model.
#pragma once
#include <mrpt/bayes/CParticleFilterCapable.h>
#include <mrpt/bayes/CParticleFilterData.h>
#include <mrpt/obs/CActionRobotMovement2D.h>

#include <vector>

#include "ariadne/core/parallel.h"
#include "ariadne/filter/params.h"
#include "ariadne/filter/particle.h"
#include "ariadne/filter/recent_scans.h"
#include "ariadne/geometry/weighted_poses.h"
#include "ariadne/grid/endpoint_likelihood.h"
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

/// MRPT's options for our parameters; CParticleFilter reads them.
mrpt::bayes::CParticleFilter::TParticleFilterOptions particleFilterOptions(const FilterParams& p);

class ParticleSet
    : public mrpt::bayes::CParticleFilterData<Particle, mrpt::bayes::particle_storage_mode::VALUE>,
      public mrpt::bayes::CParticleFilterDataImpl<
          ParticleSet, mrpt::bayes::CParticleFilterData<
                           Particle, mrpt::bayes::particle_storage_mode::VALUE>::CParticleList> {
 public:
  /// All particles at `start` with a copy of `map`. `parallel` must outlive the set.
  ParticleSet(const FilterModels& models, const core::Parallel& parallel,
              const mrpt::math::TPose2D& start, const grid::OccupancyGrid& map);

  std::size_t size() const { return m_particles.size(); }
  const Particle& operator[](std::size_t i) const { return m_particles[i].d; }
  /// s* of Eq. (8): the largest accumulated weight, ties to the lowest index.
  std::size_t best() const;
  /// Normalised weights, summing to 1.
  std::vector<double> weights() const;

  /// map_from_robot of all particles, with their normalised weights.
  geometry::WeightedPoses poses() const;

  /// Index, before the resampling of the last update, of each particle's parent; its own where
  /// there was none.
  const std::vector<std::size_t>& parents() const { return parents_; }
  /// Puts other hypotheses in the place of these, as recovery does.
  /// @param weights one a particle, sum 1
  void replace(std::vector<Particle> particles, const std::vector<double>& weights);

  /// What is drawn from now on comes from this seed.
  void reseed(std::uint64_t seed) { models_.filter.seed = seed; }

  /// What was learned of the odometry so far.
  const models::MotionLearner& learned() const { return learner_; }

  /// Number of the update that runs next; keys the random streams.
  std::size_t step() const { return step_; }
  /// Inserts the scan of the last update into every particle's map (children of one parent share
  /// the work) and ends the update. A checkpoint is kept each `checkpoint_updates`.
  void insertScan(std::size_t checkpoint_updates);

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
  const Figures& figures() const { return figures_; }

  // mrpt::bayes::CParticleFilterCapable
  void performSubstitution(const std::vector<size_t>& indices) override;

 protected:
  void prediction_and_update_pfStandardProposal(
      const mrpt::obs::CActionCollection* action, const mrpt::obs::CSensoryFrame* observation,
      const mrpt::bayes::CParticleFilter::TParticleFilterOptions& options) override;
  void prediction_and_update_pfOptimalProposal(
      const mrpt::obs::CActionCollection* action, const mrpt::obs::CSensoryFrame* observation,
      const mrpt::bayes::CParticleFilter::TParticleFilterOptions& options) override;

 private:
  struct Outcome {
    mrpt::math::TPose2D pose;
    double log_weight = 0;
    double log_likelihood = 0;
    bool match_accepted = false;
    mrpt::math::TPose2D match;  // pose that the proposal is about
    Eigen::Matrix3d information =
        Eigen::Matrix3d::Zero();  // of the scan there; zero when not fitted
  };
  void predictMatchWeigh(const mrpt::obs::CActionCollection* action,
                         const mrpt::obs::CSensoryFrame* observation);
  models::Motion motionOf(const mrpt::obs::CActionRobotMovement2D& movement) const;
  Outcome propose(std::size_t i, const models::Motion& motion) const;
  void judgeMotion(const mrpt::math::TPose2D& increment, const models::Motion& motion,
                   const Outcome& star);
  double evidenceOfPlace() const;

  FilterModels models_;
  const core::Parallel& parallel_;
  grid::EndpointLikelihood likelihood_;
  models::ScanMatcher matcher_;
  models::MotionLearner learner_;
  RecentScans recent_;
  double travelled_m_ = 0;
  std::size_t step_ = 0;
  bool map_is_known_;  // something to match against
  Figures figures_;
  std::vector<mrpt::math::TPoint2D> points_;  // of the update in progress, robot's frame
  grid::ScanShape shape_;
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> twin_;  // lowest index with the same parent in this update
};

}  // namespace ariadne::filter
