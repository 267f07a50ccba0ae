// The command line of ariadne-slam.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "run_options.h"

namespace ariadne::slam_app {

/// An empty config_file: the defaults.
struct Options : app::RunOptions {
  std::string dataset;                       ///< empty: the INI's
  std::optional<std::string> continue_from;  ///< a run or simplemap
  std::optional<std::string> start;          ///< x,y,deg
  std::string truth;                         ///< TUM file; empty: none is known
};

/// Nothing when the program is done already (--help, --version: printed to `out`). Throws
/// core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::slam_app
