#include "owner.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "ariadne/batch/claims.h"
#include "ariadne/batch/content_hash.h"

namespace ariadne::batch {

namespace fs = std::filesystem;

OwnerParts partsOf(const std::string& owner) {
  const std::size_t second = owner.rfind('-');
  const std::size_t first =
      second == 0 || second == std::string::npos ? std::string::npos : owner.rfind('-', second - 1);
  if (first == std::string::npos) return {};
  return {owner.substr(0, first), owner.substr(first + 1, second - first - 1),
          owner.substr(second + 1)};
}

std::string hostName() {
  char name[256] = "";
  ::gethostname(name, sizeof(name) - 1);
  return name;
}

std::string machineName() {
  std::error_code ignored;
  std::ifstream boot("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(boot, id);
  const std::string processes = fs::read_symlink("/proc/self/ns/pid", ignored).string();
  return hostName() + "." + hashOf(id + processes).substr(0, 6);
}

}  // namespace ariadne::batch
