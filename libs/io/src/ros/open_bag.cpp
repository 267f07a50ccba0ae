#include "open_bag.h"

#include <fstream>

#include "mcap_bag.h"
#include "ros1_bag.h"
#include "sqlite_bag.h"
#include "unpacked_file.h"

namespace ariadne::io::ros {

BagFormat formatOf(std::string_view beginning) {
  const auto is = [&](std::string_view magic) {
    return beginning.substr(0, magic.size()) == magic;
  };
  if (is("#ROSBAG V") || is("#ROSRECORD V")) return BagFormat::ros1;
  if (is("\x89MCAP")) return BagFormat::mcap;
  if (is(std::string_view("SQLite format 3\0", 16))) return BagFormat::sqlite;
  if (is("\x28\xb5\x2f\xfd")) return BagFormat::zstd;
  return BagFormat::none;
}

BagFormat formatOf(const std::filesystem::path& path) {
  std::string begin(16, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return formatOf(std::string_view(begin));
}

OpenedBag openBag(const std::filesystem::path& path) {
  switch (formatOf(path)) {
    case BagFormat::ros1:
      return {std::make_unique<Ros1Bag>(path), "ROS 1 bag"};
    case BagFormat::mcap:
      return {std::make_unique<McapBag>(path), "MCAP recording"};
    case BagFormat::sqlite:
      return {std::make_unique<SqliteBag>(path), "ROS 2 bag (SQLite)"};
    case BagFormat::zstd: {
      const UnpackedFile unpacked(path);
      if (formatOf(unpacked.path()) == BagFormat::zstd)
        throw BagDamage("compressed with zstd twice: unpack it once with 'zstd -d'");
      return openBag(unpacked.path());  // which keeps it open when its name is gone
    }
    case BagFormat::none:
      break;
  }
  throw BagDamage("no recording of ROS: neither .bag nor .db3 nor .mcap by its first bytes");
}

}  // namespace ariadne::io::ros
