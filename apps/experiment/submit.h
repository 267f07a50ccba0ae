// An experiment handed to Slurm or to GNU parallel.
#pragma once
#include <iosfwd>

#include "experiment_options.h"

namespace ariadne::experiment_app {

/// Writes the plan and hands out the slices with work that no waiting or running task has; with GNU
/// parallel also waits for them. Returns the exit code. Throws core::UsageError, core::Error.
int submit(const Options& options, std::ostream& out, std::ostream& err);

}  // namespace ariadne::experiment_app
