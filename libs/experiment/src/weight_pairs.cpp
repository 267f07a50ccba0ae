#include "ariadne/experiment/weight_pairs.h"

#include <cmath>

#include "ariadne/core/error.h"
#include "ariadne/experiment/mapper_arms.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::experiment {
namespace {

using filter::Ancestor;
using filter::AncestorPtr;
using mrpt::math::TPose2D;

/// Update of the line's last pass within radius_m of its last pose, before the present visit; its
/// first update where it never was here.
std::size_t lastPass(const AncestorPtr& leaf, double radius_m) {
  std::size_t step = 0;
  bool left = false;
  filter::forEachAncestor(leaf, [&](const Ancestor& a) {
    const bool near = geometry::distance(a.pose(), leaf->pose()) < radius_m;
    left = left || !near;
    step = a.step();
    return !(left && near);
  });
  return step;
}

class Pairs {
 public:
  Pairs(const slam::Mapper& mapper, const sim::SimulatedDrive& seen, double radius_m,
        const PairParams& which)
      : mapper_(mapper), seen_(seen), radius_m_(radius_m), which_(which) {}

  /// @param at index of the step that the filter is being updated with
  void add(std::size_t at) {
    const filter::ParticleSet& particles = mapper_.particles();
    true_poses_.push_back(seen_.truth[at].pose);
    evidence_.push_back(particles.figures().evidence);
    const AncestorPtr& star = particles[particles.best()].ancestor;
    const std::size_t passes = filter::earlierPasses(star, radius_m_);
    const std::size_t since = lastPass(star, radius_m_);
    const TPose2D moved = geometry::relativePose(true_poses_[since], true_poses_.back());
    struct One {
      double off_m;
      double ln_weight;
    };
    std::vector<One> all;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const AncestorPtr& leaf = particles[i].ancestor;
      const TPose2D from = filter::ancestorAt(leaf, since)->pose();
      const One one{geometry::distance(geometry::relativePose(from, leaf->pose()), moved),
                    lnWeightOf(leaf)};
      for (const One& other : all)
        if (std::abs(one.off_m - other.off_m) >= which_.least_m)
          pairs_.push_back({passes, one.off_m < other.off_m ? one.ln_weight - other.ln_weight
                                                            : other.ln_weight - one.ln_weight});
      all.push_back(one);
    }
  }

  std::vector<WeightPair> take() { return std::move(pairs_); }

 private:
  /// Of the scans of the stretch.
  double lnWeightOf(const AncestorPtr& leaf) const {
    double sum = 0;
    double travelled_m = 0;
    filter::forEachAncestor(leaf, [&](const Ancestor& a) {
      sum += a.logWeight() / evidence_[a.step()];
      travelled_m += std::hypot(a.motion().x, a.motion().y);
      return travelled_m < which_.stretch_m;
    });
    return sum;
  }

  const slam::Mapper& mapper_;
  const sim::SimulatedDrive& seen_;
  double radius_m_;
  PairParams which_;
  std::vector<TPose2D> true_poses_;  // one an update, as the next
  std::vector<double> evidence_;
  std::vector<WeightPair> pairs_;
};

}  // namespace

std::vector<WeightPair> weightPairs(const sim::SimulatedDrive& seen, const slam::SlamParams& params,
                                    std::uint64_t seed, const PairParams& which) {
  if (params.filter.new_ground_weight <= 0)
    throw core::UsageError("[filter] new_ground_weight must be over 0 for its pairs to be seen");
  slam::SlamParams seeded = params;
  seeded.filter.seed = seed;
  slam::Mapper mapper(seeded, 1);
  Pairs pairs(mapper, seen, params.filter.revisit_radius_m, which);
  std::size_t at = 0;
  MapperArms::afterWeighing(mapper, [&] { pairs.add(at); });
  for (; at < seen.steps.size(); ++at) mapper.process(seen.steps[at]);
  return pairs.take();
}

}  // namespace ariadne::experiment
