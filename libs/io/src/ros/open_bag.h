// Which reader a file needs, told by how it begins.
#pragma once
#include <filesystem>
#include <memory>
#include <string_view>

#include "bag_reader.h"

namespace ariadne::io::ros {

enum class BagFormat { none, ros1, mcap, sqlite, zstd };
BagFormat formatOf(std::string_view beginning);
BagFormat formatOf(const std::filesystem::path& path);

struct OpenedBag {
  std::unique_ptr<BagReader> reader;
  const char* format = "";  ///< what to call it
};

/// Throws core::Error when it cannot be opened, BagDamage when it is no recording. What was
/// compressed as a whole (rosbag2's file mode) is unpacked into a temporary file, which is gone
/// when the reader is.
OpenedBag openBag(const std::filesystem::path& path);

}  // namespace ariadne::io::ros
