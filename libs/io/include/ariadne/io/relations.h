// Relations files of the SLAM benchmark (Kuemmerle et al. 2009): one `time1 time2 x y z roll pitch
// yaw` a line, gzip or not; `#` opens a comment.
#pragma once
#include <filesystem>
#include <vector>

#include "ariadne/geometry/trajectory.h"

namespace ariadne::io {

/// Seconds, metres, radians; of a motion in space x, y and yaw are kept. Throws core::Error naming
/// file and line for anything but eight finite numbers a line, and for a file without a relation.
std::vector<geometry::Relation> readRelations(const std::filesystem::path& path);

}  // namespace ariadne::io
