// ariadne-explore without a process: tests call it.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// Returns the exit code. Results are told on `out`, progress and errors on `err`.
int runExploreApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
