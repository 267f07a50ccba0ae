// Which files a log is made of.
#pragma once
#include <filesystem>
#include <vector>

namespace ariadne::io {

/// The file itself; of a ROS recording that is a folder, or that its metadata.yaml stands for, the
/// metadata (where there are) and all parts, in their order. Throws core::Error when a part is
/// missing or a folder holds no recording.
std::vector<std::filesystem::path> filesOfLog(const std::filesystem::path& log);

}  // namespace ariadne::io
