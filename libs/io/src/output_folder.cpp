#include "ariadne/io/output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

void create(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

/// Permissions and mount flags lie (root may write anywhere but on a read-only disk): a file tells.
void probe(const fs::path& folder) {
  const fs::path file = folder / fmt::format(".ariadne-probe-{}", ::getpid());
  writeWhole(file, std::string_view("x"));
  std::error_code ignored;
  fs::remove(file, ignored);
}

bool isEmptyFolder(const fs::path& folder) {
  std::error_code error;
  const bool empty = fs::is_empty(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot read the folder {}: {}", folder.string(), error.message()));
  return empty;
}

}  // namespace

void prepareOutputFolder(const fs::path& folder, const std::vector<std::string>& names,
                         bool overwrite) {
  std::error_code ignored;
  if (fs::exists(folder, ignored)) {
    if (!fs::is_directory(folder, ignored))
      throw core::UsageError(fmt::format("{} is no folder: name another", folder.string()));
    if (!overwrite && !isEmptyFolder(folder))
      throw core::UsageError(fmt::format(
          "the folder {} holds files: name another, or give --overwrite to replace the files of "
          "an earlier run",
          folder.string()));
    for (const std::string& name : names)
      if (fs::is_directory(folder / name, ignored))
        throw core::UsageError(
            fmt::format("{} is a folder and would be in the way", (folder / name).string()));
  }
  create(folder);
  probe(folder);
}

}  // namespace ariadne::io
