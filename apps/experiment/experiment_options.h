// The command line of ariadne-experiment.
#pragma once
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/batch/text_table.h"

namespace ariadne::experiment_app {

enum class Command { run, work, table, plot, report, status };

struct Options {
  Command command = Command::run;
  std::string ini;
  std::string folder;
  int jobs = 1;
  std::optional<std::uint64_t> first;
  std::optional<std::uint64_t> last;
  bool dry_run = false;
  bool again_failed = false;
  bool quiet = false;
  std::size_t slice = 1;
  std::size_t slices = 1;
  batch::TableFormat format = batch::TableFormat::text;
};

/// Nothing when --help or --version was asked for and given. Throws core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::experiment_app
