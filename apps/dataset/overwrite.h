// Files of others are not replaced by accident.
#pragma once
#include <filesystem>

namespace ariadne {

/// Throws core::Error when something is there and `overwrite` is false.
void refuseToOverwrite(const std::filesystem::path& path, bool overwrite);

}  // namespace ariadne
