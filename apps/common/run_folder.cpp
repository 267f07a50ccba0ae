#include "run_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cctype>
#include <ctime>

namespace ariadne::app {
namespace {

namespace fs = std::filesystem;

/// "intel" of "/data/intel.clf.gz"; what shells dislike becomes a hyphen.
std::string shortName(const fs::path& input) {
  std::string name = input.filename().string();
  for (const char* end : {".gz", ".rawlog", ".clf", ".log", ".carmen", ".bag", ".db3", ".mcap",
                          ".zstd", ".world", ".yaml", ".gridmap", ".png", ".pgm", ".bmp"})
    if (name.size() > std::string(end).size() && fs::path(name).extension() == end)
      name = fs::path(name).stem().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '_') c = '-';
  return name;
}

}  // namespace

std::string newFolderFor(const fs::path& input) {
  const std::string base = fmt::format("ariadne-{}-{:%Y%m%d-%H%M%S}", shortName(input),
                                       fmt::localtime(std::time(nullptr)));
  std::string name = base;
  std::error_code ignored;
  for (int i = 2; fs::exists(name, ignored); ++i) name = fmt::format("{}-{}", base, i);
  return name;
}

}  // namespace ariadne::app
