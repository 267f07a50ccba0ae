#include "ariadne/io/dataset_place.h"

#include <cstdlib>

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

/// A file, or the folder of a recording.
bool isThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

fs::path datasetPlace(const std::string& name, const fs::path& folder) {
  const fs::path here = (folder / name).lexically_normal();
  if (isThere(here)) return here;
  if (const char* given = std::getenv("ARIADNE_DATASETS")) {
    const fs::path there = fs::path(given) / name;
    return isThere(there) ? fs::absolute(there).lexically_normal() : here;
  }
  // An INI named without its folder has an empty one.
  fs::path above = fs::absolute(folder / ".").lexically_normal();
  for (; above != above.root_path(); above = above.parent_path())
    if (isThere(above / "shared" / "datasets" / name)) return above / "shared" / "datasets" / name;
  return here;
}

}  // namespace ariadne::io
