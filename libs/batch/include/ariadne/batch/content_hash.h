// What files and texts hold, as 32 hexadecimal digits (MD5: against mix-ups, not against an enemy).
#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace ariadne::batch {

/// Of the text's bytes.
std::string hashOf(const std::string& text);

/// Size, time and inode of a file and of what counts with it (FileHashes): another file has others.
/// Empty when it is not there.
std::string stampOf(const std::filesystem::path& file);

/// Hashes of files, each read once while this lives.
class FileHashes {
 public:
  /// A YAML of ROS map_server counts with its picture, a ROS recording that is a folder or its
  /// metadata.yaml with all its parts. Throws core::Error when something cannot be read.
  const std::string& of(const std::filesystem::path& file);

 private:
  std::map<std::string, std::string> known_;
};

}  // namespace ariadne::batch
