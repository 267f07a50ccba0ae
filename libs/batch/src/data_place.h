// Logs and worlds that an experiment names.
#pragma once
#include <string>

namespace ariadne::batch {

/// What to install or where to get a data file that is missing.
extern const char* const kWhereDataAre;

/// Why there is no data under this path, which must be absolute; empty for a file or a recording in
/// a folder.
std::string whyNoData(const std::string& path);

}  // namespace ariadne::batch
