// Everything that reads a file or a text of a user's, by name.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace ariadne::fuzz {

struct Reader {
  const char* name;
  const char* file;  ///< what the input is called in its folder
  /// Reads it as our programs do. Throws core::Error for what it cannot use, and nothing else.
  void (*read)(const std::filesystem::path& file);
};

const std::vector<Reader>& readers();

/// Gives the reader a file of these bytes, in `folder`. Returns whether they were of use.
bool tryReader(const Reader& reader, const std::filesystem::path& folder, std::string_view bytes);

}  // namespace ariadne::fuzz
