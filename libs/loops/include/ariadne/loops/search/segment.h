// The path since an entry point, drawn given its closures: a better sampler for Eq. (13). The steps
// of the path are a chain of Gaussians, the closures tie its nodes together; a sample is found by
// perturbing every measurement by its own noise and optimising (perturb and optimise: exact where
// the problem is linear). After the block proposal of Beevers and Huang, "Fixed-lag sampling
// strategies for particle filtering SLAM", ICRA 2007; here the lag is the loop.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/loops/search/contacts.h"

namespace ariadne::loops {

/// Covariance that no closure is known better than, m^2 and rad^2: maps are smeared by about a
/// cell.
Eigen::Matrix3d tieFloor();

/// A measured relative pose between two updates.
struct Tie {
  std::size_t first = 0;   ///< update; where it is not in the segment it is known and stays
  std::size_t second = 0;  ///< update in the segment
  mrpt::math::TPose2D first_from_second;
  Eigen::Matrix3d information;  ///< of (x, y, heading) in the frame of `first`
  bool doubted = true;          ///< its weight falls when the others disagree
};

/// Ties of a path at its contacts, measured on the path itself.
std::vector<Tie> tiesOf(const Track& track, const std::vector<Contact>& contacts);

/// The path since an entry point, drawn given its closures.
struct SegmentSample {
  std::vector<mrpt::math::TPose2D> poses;  ///< of updates te + 1 to the last
  /// By how much the ties that are not doubted add to half the squared Mahalanobis distance of the
  /// path from all that was measured: minus the log of the density of the needed correction,
  /// constants left out.
  double cost = 0;
};

/// @param te update at which the segment begins; its pose stays
/// @param rng null gives the mean
SegmentSample drawSegment(const Track& track, std::size_t te, const std::vector<Tie>& ties,
                          core::RandomStream* rng);

/// Covariance of the last pose of the path given each update, (x, y, heading), map frame: the
/// motions since, nothing else.
std::vector<Eigen::Matrix3d> driftSinceEach(const Track& track);

}  // namespace ariadne::loops
