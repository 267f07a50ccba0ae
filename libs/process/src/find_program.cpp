#include "ariadne/process/find_program.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>

namespace ariadne::process {

namespace fs = std::filesystem;

bool canRun(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

fs::path findInPath(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && canRun(fs::path(folder) / name))
      return fs::absolute(fs::path(folder) / name);
  return {};
}

fs::path findSister(const std::string& name) {
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  return canRun(beside) ? beside : findInPath(name);
}

}  // namespace ariadne::process
