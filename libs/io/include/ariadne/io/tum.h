// Trajectories in the TUM RGB-D format: one `time x y z qx qy qz qw` a line, `#` opens a comment.
// https://cvg.cit.tum.de/data/datasets/rgbd-dataset/file_formats
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::io {

/// The poses of a file, in order of time (stable where stamps repeat): UNIX seconds, metres,
/// radians. Of a pose in space x, y and the heading are kept.
/// Throws core::Error naming file and line for anything but eight finite numbers a line, a
/// quaternion of length 0, times or places out of reason, and for a file without a pose.
geometry::Trajectory readTum(const std::filesystem::path& path);

/// Writes the poses (z = 0), each of `header` as a comment line before them. Stamps have 7
/// decimals, so UNIX times read back as the same double. Throws core::Error naming the path.
void writeTum(const std::filesystem::path& path, const geometry::Trajectory& trajectory,
              const std::vector<std::string>& header = {});

}  // namespace ariadne::io
