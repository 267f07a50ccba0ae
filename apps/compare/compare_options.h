// The command line of ariadne-compare.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace ariadne::compare_app {

struct Options {
  std::string config_file;
  std::string dataset;                ///< empty: the INI's
  std::vector<std::string> settings;  ///< section.key=value of ariadne-slam, in order
  std::optional<std::string> particles;
  std::optional<std::string> seed;  ///< of the first repeat
  int threads = 1;                  ///< of ariadne-slam; stock has one
  std::optional<int> pf_algorithm;  ///< of stock
  std::string stock_ini;            ///< whose other settings stock takes; empty: the default
  int repeats = 3;
  std::string truth;
  std::string relations;
  double max_gap_s = 1;
  std::vector<std::string> requirements;
  std::string out;   ///< empty: a new folder
  std::string json;  ///< empty: none
  std::string slam_program;
  std::string stock_program;
  bool overwrite = false;
  bool quiet = false;
};

/// Nothing when the program is done already (--help, --version: printed to `out`). Throws
/// core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::compare_app
