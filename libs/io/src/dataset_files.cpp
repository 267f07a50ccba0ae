#include "ariadne/io/dataset_files.h"

#include <string>

#include "ros/bag_folder.h"

namespace ariadne::io {

std::vector<std::filesystem::path> filesOfLog(const std::filesystem::path& log) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  std::vector<std::string> remarks;
  std::vector<fs::path> files = ros::filesOfBag(log, remarks);
  const fs::path metadata = fs::is_directory(log, ignored) ? log / ros::kMetadataName : log;
  if (files.front() != metadata && fs::is_regular_file(metadata, ignored))
    files.insert(files.begin(), metadata);
  return files;
}

}  // namespace ariadne::io
