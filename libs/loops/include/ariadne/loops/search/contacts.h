// Where a path came by its own places again and its scans agree: the closures that the filter made
// by itself.
#pragma once
#include <Eigen/Dense>
#include <cstddef>
#include <optional>
#include <vector>

#include "ariadne/loops/search/track.h"

namespace ariadne::loops {

/// Two updates that saw the same walls.
struct Contact {
  std::size_t first = 0;
  std::size_t second = 0;
  /// Of second seen from first: how well the walls that both saw hold (x, y, heading) to each
  /// other.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  /// Of second seen from first where it was measured; else the path itself says it.
  std::optional<mrpt::math::TPose2D> first_from_second = {};
};

/// When a place of the path counts as seen again.
struct ContactParams {
  double radius_m = 8;       ///< the robot was this near to the earlier place
  double tolerance_m = 0.2;  ///< a beam's end agrees within this
  double least_share = 0.5;  ///< of the later scan's ends agree
};

/// Contacts of update `second` with the nearest places of a while ago, of longer ago and of long
/// ago (by the path since), where the scans agree. What was seen again within some metres counts as
/// well: it is what holds a path together better than its steps alone.
std::vector<Contact> findContacts(const Track& track, const std::vector<ScanHits>& hits,
                                  std::size_t second, const ContactParams& params);

/// How far each update is from the last one along the path and through contacts, m (Dijkstra).
std::vector<double> distancesFromNow(const Track& track, const std::vector<Contact>& contacts);

}  // namespace ariadne::loops
