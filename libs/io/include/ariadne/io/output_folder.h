// The folder that a run writes to: new or empty, unless overwriting was asked for.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::io {

/// Makes `folder` (and its parents) ready to take files of these names, and proves before the work
/// starts that files can be written there. Nothing is deleted: with `overwrite` the files of these
/// names are replaced later, one by one and whole; others stay.
/// Throws core::UsageError when the folder holds something and `overwrite` is false or when one of
/// the names is a folder, core::Error naming the path and the system's reason when it cannot be
/// made or written.
void prepareOutputFolder(const std::filesystem::path& folder, const std::vector<std::string>& names,
                         bool overwrite);

}  // namespace ariadne::io
