// How far a program is in a file that it reads from front to back.
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>

namespace ariadne::process {

/// Of the file's bytes, 0 to 1, as Linux knows it (/proc): the program need tell nothing, and it
/// costs the program nothing. Nothing while the process does not have the file open, or is not ours
/// to look at.
std::optional<double> shareRead(pid_t pid, const std::filesystem::path& file);

}  // namespace ariadne::process
