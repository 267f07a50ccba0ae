#include "bag_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "ariadne/core/error.h"
#include "ariadne/io/yaml.h"
#include "open_bag.h"

namespace ariadne::io::ros {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// drive_2 before drive_10: a run of digits counts as a number.
bool numberedBefore(const fs::path& a_path, const fs::path& b_path) {
  const std::string a = a_path.filename().string(), b = b_path.filename().string();
  const auto digits = [](const std::string& s, std::size_t at) {
    std::size_t end = at;
    while (end < s.size() && std::isdigit(static_cast<unsigned char>(s[end])) != 0) ++end;
    return s.substr(at, end - at);
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const std::string da = digits(a, i), db = digits(b, j);
    if (!da.empty() && !db.empty() && da != db)
      return da.size() != db.size() ? da.size() < db.size() : da < db;
    if (a[i] != b[j]) return a[i] < b[j];
    i += std::max<std::size_t>(1, da.size());
    j += std::max<std::size_t>(1, db.size());
  }
  return a.size() < b.size();
}

/// The name without its digits: the parts of a recording differ in these alone.
std::string withoutDigits(const fs::path& path) {
  std::string name = path.filename().string();
  name.erase(std::remove_if(name.begin(), name.end(),
                            [](unsigned char c) { return std::isdigit(c) != 0; }),
             name.end());
  return name;
}

/// Before version 4 of the metadata the names started with the folder's own.
fs::path placeOf(const std::string& name, const fs::path& folder) {
  for (const fs::path& place : {folder / name, folder.parent_path() / name})
    for (const char* end : {"", ".zstd"})
      if (fs::path file = place.string() + end; isFile(file)) return file;
  throw core::Error(
      fmt::format("{} names the file {}, which is not there; to map what is left of the recording, "
                  "take the name out of relative_file_paths",
                  (folder / kMetadataName).string(), name));
}

std::vector<fs::path> namedFiles(const fs::path& folder) {
  const YamlValue list = readYaml(folder / kMetadataName)
                             .at("rosbag2_bagfile_information", "rosbag2_bagfile_information:")
                             .at("relative_file_paths", "relative_file_paths: [drive_0.mcap]");
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < list.size(); ++i) files.push_back(placeOf(list[i].text(), folder));
  if (files.empty()) throw list.error("no file is named");
  return files;
}

std::vector<fs::path> foundFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (entry.is_regular_file(code) && formatOf(entry.path()) != BagFormat::none)
      files.push_back(entry.path());
  if (code) throw core::Error(fmt::format("cannot read {}: {}", folder.string(), code.message()));
  std::sort(files.begin(), files.end(), numberedBefore);
  return files;
}

}  // namespace

std::vector<fs::path> filesOfBag(const fs::path& path, std::vector<std::string>& remarks) {
  std::error_code ignored;
  if (path.filename() == kMetadataName) return namedFiles(path.parent_path());
  if (!fs::is_directory(path, ignored)) return {path};
  const fs::path folder = path.filename().empty() ? path.parent_path() : path;
  if (isFile(folder / kMetadataName)) return namedFiles(folder);
  std::vector<fs::path> files = foundFiles(folder);
  if (files.empty())
    throw core::Error(fmt::format(
        "{} is a directory and no recording of ROS: there is neither {} nor .bag, .db3 or .mcap",
        folder.string(), kMetadataName));
  for (const fs::path& file : files)
    if (withoutDigits(file) != withoutDigits(files[0]))
      throw core::Error(fmt::format(
          "{} holds several recordings, such as {} and {}, and no {} that says which "
          "belong together: name one file",
          folder.string(), files[0].filename().string(), file.filename().string(), kMetadataName));
  if (files.size() > 1)
    remarks.push_back(
        fmt::format("there is no {}: the {} recordings in the folder are taken for parts of one, "
                    "from {} to {}",
                    kMetadataName, files.size(), files.front().filename().string(),
                    files.back().filename().string()));
  return files;
}

}  // namespace ariadne::io::ros
