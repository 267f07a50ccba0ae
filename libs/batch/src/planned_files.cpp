#include "planned_files.h"

#include <fmt/format.h>

#include "ariadne/batch/content_hash.h"
#include "ariadne/core/error.h"

namespace ariadne::batch {

void PlannedFiles::check() {
  FileHashes hashes;
  for (const auto& [file, hash] : files_) {
    const std::string stamp = stampOf(file);
    std::string& before = stamps_[file];
    if (!before.empty() && before == stamp) continue;
    if (hashes.of(file) != hash)
      throw core::Error(fmt::format(
          "{} is not what it was when the plan was made: plan again with ariadne-experiment run",
          file));
    before = stamp;
  }
}

}  // namespace ariadne::batch
