// Where a log that is not part of the project is looked for.
#pragma once
#include <filesystem>
#include <string>

namespace ariadne::io {

/// The file `name`, as infinite-corridor/infinite-corridor-corrected.log.gz: from `folder`; then
/// in the folder that the environment's ARIADNE_DATASETS names or, when that is not set, in the
/// nearest folder shared/datasets beside `folder` or one above it. When it is in none of them, its
/// path from `folder`, for the error of who opens it.
std::filesystem::path datasetPlace(const std::string& name, const std::filesystem::path& folder);

}  // namespace ariadne::io
