// Which files make up a recording that is a folder.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::io::ros {

constexpr const char* kMetadataName = "metadata.yaml";

/// The file itself; or of a folder, or of the metadata.yaml in it, the files that it names, or
/// where there is none all recordings in it, in the order of their numbers (which goes into
/// `remarks`). Throws core::Error when a file is missing or there is none.
std::vector<std::filesystem::path> filesOfBag(const std::filesystem::path& path,
                                              std::vector<std::string>& remarks);

}  // namespace ariadne::io::ros
