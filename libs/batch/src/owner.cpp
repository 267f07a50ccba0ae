#include "owner.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ariadne/batch/claims.h"
#include "ariadne/batch/content_hash.h"

namespace ariadne::batch {

namespace fs = std::filesystem;

std::string startOf(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) fields >> field;
  return field;
}

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
