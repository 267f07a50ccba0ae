#include "ariadne/io/dataset_place.h"

#include <cstdlib>

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

fs::path datasetPlace(const std::string& name, const fs::path& folder) {
  const fs::path here = (folder / name).lexically_normal();
  if (isFile(here)) return here;
  if (const char* given = std::getenv("ARIADNE_DATASETS")) {
    const fs::path there = fs::path(given) / name;
    return isFile(there) ? fs::absolute(there).lexically_normal() : here;
  }
  fs::path above = fs::absolute(folder).lexically_normal();
  for (; above != above.root_path(); above = above.parent_path())
    if (isFile(above / "shared" / "datasets" / name)) return above / "shared" / "datasets" / name;
  return here;
}

}  // namespace ariadne::io
