// How far two scans agree at a relative pose, and what that tells about it.
#pragma once
#include <Eigen/Dense>

#include "ariadne/loops/search/contacts.h"

namespace ariadne::loops {

/// Share of the ends of `scan` (placed by `pose`) near one of `wall`; adds what the agreeing ones
/// know of the pose, (x, y, heading) in the frame of `wall`. Along an axis in which under
/// params.least_share of the walls agree, nothing is known.
double agreement(const ScanHits& wall, const ScanHits& scan, const mrpt::math::TPose2D& pose,
                 const ContactParams& params, Eigen::Matrix3d& information);

}  // namespace ariadne::loops
