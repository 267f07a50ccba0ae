// Options of the programs that make a run out of an INI: ariadne-slam, ariadne-explore.
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/io/ini_text.h"

namespace ariadne::app {

struct RunOptions {
  std::string config_file;
  std::vector<std::string> settings;  ///< section.key=value, in order
  // Dedicated flags as typed; the parameters' own tables check them.
  std::optional<std::string> particles;
  std::optional<std::string> seed;
  std::optional<std::string> threads;
  std::optional<std::string> out;
  bool no_pictures = false;
  bool overwrite = false;
  bool print_config = false;
  bool print_parameters = false;
  bool quiet = false;
};

/// All but CONFIG, which stands first among the program's own. @param input of the folder's name
void declareRunOptions(CLI::App& app, RunOptions& options, const std::string& input);

/// The dedicated flags as entries, so that they are checked and explained like the INI's.
std::vector<io::IniEntry> flagEntries(const RunOptions& options);

}  // namespace ariadne::app
