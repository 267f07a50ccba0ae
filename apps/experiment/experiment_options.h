// The command line of ariadne-experiment.
#pragma once
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/batch/text_table.h"
#include "ariadne/cluster/parallel_command.h"
#include "ariadne/cluster/slurm_options.h"

namespace ariadne::experiment_app {

enum class Command { run, work, table, plot, report, publish, status, submit, collect };

enum class Engine { slurm, parallel };

struct Options {
  Command command = Command::run;
  std::string ini;
  std::string folder;
  std::string to;  ///< of export
  int jobs = 0;
  std::optional<std::uint64_t> first;
  std::optional<std::uint64_t> last;
  std::vector<std::string> where;  ///< "world=small,eight": of run
  bool dry_run = false;
  bool again_failed = false;
  bool quiet = false;
  std::size_t slice = 1;
  std::size_t slices = 1;
  batch::TableFormat format = batch::TableFormat::text;
  Engine engine = Engine::slurm;
  std::size_t handed_slices = 0;  ///< of submit; 0: by the number of runs
  bool script_only = false;
  cluster::SlurmOptions slurm;
  cluster::ParallelOptions parallel;
};

/// Nothing when --help or --version was asked for and given. Throws core::UsageError.
std::optional<Options> parseOptions(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::experiment_app
