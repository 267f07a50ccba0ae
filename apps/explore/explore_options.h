// The command line of ariadne-explore.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "run_options.h"

namespace ariadne::explore_app {

struct Options : app::RunOptions {
  std::optional<std::string> world;  ///< as typed, as the next two
  std::optional<std::string> random;
  std::optional<std::string> start;
  std::optional<std::string> strategy;
};

/// Nothing when the program is done already (--help, --version: printed to `out`). Throws
/// core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::explore_app
