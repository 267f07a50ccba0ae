// Logs and INIs share the place behind a program's name: which of the two a file is.
#pragma once
#include <filesystem>

namespace ariadne::io {

/// Whether this is an existing log or recording rather than an INI. What is called *.ini is none,
/// nor is a text whose first line that is no comment is `[section]` or `key = value`, nor one
/// without such a line, nor a file that cannot be read. Folders are recordings of ROS 2.
bool looksLikeLog(const std::filesystem::path& path);

}  // namespace ariadne::io
