#include "overwrite.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"

namespace ariadne {

void refuseToOverwrite(const std::filesystem::path& path, bool overwrite) {
  std::error_code ignored;
  if (!overwrite && std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
    throw core::Error(fmt::format("{} exists; -w replaces it", path.string()));
}

}  // namespace ariadne
