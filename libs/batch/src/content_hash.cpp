#include "ariadne/batch/content_hash.h"

#include <fmt/format.h>
#include <mrpt/system/md5.h>
#include <sys/stat.h>

#include <sstream>

#include "ariadne/batch/success.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

/// The picture a map_server YAML names; empty when it names none that exists.
fs::path pictureOf(const fs::path& yaml, const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, 6, "image:") != 0) continue;
    const auto words = splitList(line.substr(6), " \t\r\"'");
    std::error_code ignored;
    if (words.empty()) return {};
    const fs::path picture = yaml.parent_path() / words[0];
    return fs::is_regular_file(picture, ignored) ? picture : fs::path();
  }
  return {};
}

bool isMapYaml(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

}  // namespace

std::string stampOf(const fs::path& file) {
  struct stat s {};
  if (::stat(file.c_str(), &s) != 0) return {};
  const fs::path picture = isMapYaml(file) ? pictureOf(file, io::readWhole(file)) : fs::path();
  return fmt::format("{} {} {} {}.{} {}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec,
                     s.st_mtim.tv_nsec, isMapYaml(picture) ? "" : stampOf(picture));
}

std::string hashOf(const std::string& text) { return mrpt::system::md5(text); }

const std::string& FileHashes::of(const fs::path& file) {
  const auto [at, is_new] = known_.try_emplace(file.string());
  if (!is_new) return at->second;
  try {
    const std::string text = io::readWhole(file);
    std::string hash = hashOf(text);
    if (isMapYaml(file))
      if (const fs::path picture = pictureOf(file, text); !picture.empty())
        hash = hashOf(hash + hashOf(io::readWhole(picture)));
    at->second = hash;
  } catch (...) {
    known_.erase(at);
    throw;
  }
  return at->second;
}

}  // namespace ariadne::batch
