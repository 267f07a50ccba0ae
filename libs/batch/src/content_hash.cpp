#include "ariadne/batch/content_hash.h"

#include <fmt/format.h>
#include <mrpt/system/md5.h>
#include <sys/stat.h>

#include <optional>

#include "ariadne/io/ros_map_file.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

bool isMapYaml(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

std::optional<fs::path> pictureOf(const fs::path& file) {
  return isMapYaml(file) ? io::pictureOfRosMap(file) : std::nullopt;
}

}  // namespace

std::string stampOf(const fs::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0) return {};
  const auto picture = pictureOf(file);
  return fmt::format("{} {} {} {}.{} {}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec,
                     s.st_mtim.tv_nsec, !picture || isMapYaml(*picture) ? "" : stampOf(*picture));
}

std::string hashOf(const std::string& text) { return mrpt::system::md5(text); }

const std::string& FileHashes::of(const fs::path& file) {
  const auto [at, is_new] = known_.try_emplace(file.string());
  if (!is_new) return at->second;
  try {
    std::string hash = hashOf(io::readWhole(file));
    if (const auto picture = pictureOf(file)) hash = hashOf(hash + hashOf(io::readWhole(*picture)));
    at->second = hash;
  } catch (...) {
    known_.erase(at);
    throw;
  }
  return at->second;
}

}  // namespace ariadne::batch
