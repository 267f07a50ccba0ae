#include "ariadne/batch/content_hash.h"

#include <fmt/format.h>
#include <mrpt/system/md5.h>
#include <sys/stat.h>

#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset_files.h"
#include "ariadne/io/ros_map_file.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

/// The file, the picture that a YAML of a ROS map names, the parts of a recording in a folder.
std::vector<fs::path> partsOf(const fs::path& file) {
  std::error_code ignored;
  const bool is_yaml = file.extension() == ".yaml" || file.extension() == ".yml";
  if (is_yaml)
    if (const auto picture = io::pictureOfRosMap(file)) return {file, *picture};
  if (!is_yaml && !fs::is_directory(file, ignored)) return {file};
  try {
    return io::filesOfLog(file);
  } catch (const core::Error&) {  // who reads it as a recording says why it is none
    return {file};
  }
}

std::string stampOfPart(const fs::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0) return {};
  return fmt::format("{} {} {} {}.{} ", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec,
                     s.st_mtim.tv_nsec);
}

}  // namespace

std::string stampOf(const fs::path& file) {
  std::string stamps;
  for (const fs::path& part : partsOf(file)) stamps += stampOfPart(part);
  return stamps;
}

std::string hashOf(const std::string& text) { return mrpt::system::md5(text); }

const std::string& FileHashes::of(const fs::path& file) {
  const auto found = known_.find(file.string());
  if (found != known_.end()) return found->second;
  std::string all;
  const auto parts = partsOf(file);
  for (const fs::path& part : parts) all += hashOf(io::readWhole(part));
  return known_[file.string()] = parts.size() == 1 ? all : hashOf(all);
}

}  // namespace ariadne::batch
