// The tree of ancestors: one immutable node a filter update and particle, shared by all who descend
// from it, freed when nobody does. Walking up from a particle gives its trajectory.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace ariadne::filter {

class Ancestor;
/// Null above the first update.
using AncestorPtr = std::shared_ptr<const Ancestor>;

/// A particle as it was at one update: the line through parents is its trajectory. Lines share what
/// they have in common, and what no particle descends from is gone.
class Ancestor {
 public:
  /// @param parent null at the root
  /// @param log_weight increment of the log weight in this step, as it entered Eq. (8)
  Ancestor(AncestorPtr parent, std::size_t step, const mrpt::math::TPose2D& map_from_robot,
           double log_weight);
  /// A pose that was bent or moved since it was drawn.
  /// @param motion as drawn, see motion()
  Ancestor(AncestorPtr parent, std::size_t step, const mrpt::math::TPose2D& map_from_robot,
           double log_weight, const mrpt::math::TPose2D& motion)
      : parent_(std::move(parent)),
        step_(step),
        map_from_robot_(map_from_robot),
        motion_(motion),
        log_weight_(log_weight),
        accumulated_((parent_ ? parent_->accumulated_ : 0) + log_weight) {}
  ~Ancestor();
  Ancestor(const Ancestor&) = delete;
  Ancestor& operator=(const Ancestor&) = delete;

  /// The update before; null at the first.
  const AncestorPtr& parent() const { return parent_; }
  /// Number of the filter update.
  std::size_t step() const { return step_; }
  /// map_from_robot, m and rad.
  const mrpt::math::TPose2D& pose() const { return map_from_robot_; }
  /// From the parent's pose to this as the filter drew it, robot's frame: what was measured, which
  /// a closure that bends the path leaves alone. Zero at the root.
  const mrpt::math::TPose2D& motion() const { return motion_; }
  /// Increment of the log weight in this step, as it entered Eq. (8).
  double logWeight() const { return log_weight_; }
  /// a of Eq. (8): sum of the increments along the line, this one's too.
  double accumulated() const { return accumulated_; }

 private:
  mutable AncestorPtr parent_;  // let go one by one by the destructor
  std::size_t step_;
  mrpt::math::TPose2D map_from_robot_;
  mrpt::math::TPose2D motion_;
  double log_weight_;
  double accumulated_;
};

/// Calls f(node) from `leaf` to the root until f returns false.
template <class F>
void forEachAncestor(const AncestorPtr& leaf, F&& f) {
  for (const Ancestor* a = leaf.get(); a && f(*a); a = a->parent().get()) {
  }
}

/// The node of update `step` on the line of `leaf`; null when it has none.
AncestorPtr ancestorAt(const AncestorPtr& leaf, std::size_t step);

/// How many nodes of update `step` the lines of all leaves go through; fewer than leaves where
/// lines have coalesced. The leaves must be of one update, and their lines reach back to `step`.
std::size_t distinctAncestors(const std::vector<AncestorPtr>& leaves, std::size_t step);

/// How often the line of `leaf` passed within radius_m of its last pose before the present visit:
/// separate runs of nodes inside the circle, the one that `leaf` is in not counted.
std::size_t earlierPasses(const AncestorPtr& leaf, double radius_m);

}  // namespace ariadne::filter
