// The command line of ariadne-slam.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ariadne::slam_app {

struct Options {
  std::string config_file;            ///< empty: the defaults
  std::string dataset;                ///< empty: the INI's
  std::vector<std::string> settings;  ///< section.key=value, in order
  // Dedicated flags as typed; the parameters' own tables check them.
  std::optional<std::string> particles;
  std::optional<std::string> seed;
  std::optional<std::string> threads;
  std::optional<std::string> out;
  std::string truth;  ///< TUM file; empty: none is known
  bool no_pictures = false;
  bool overwrite = false;
  bool print_config = false;
  bool print_parameters = false;
  bool quiet = false;
};

/// Nothing when the program is done already (--help, --version: printed to `out`). Throws
/// core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::slam_app
