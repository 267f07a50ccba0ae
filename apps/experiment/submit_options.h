// The options of ariadne-experiment submit.
#pragma once
#include <CLI/CLI.hpp>

#include "experiment_options.h"

namespace ariadne::experiment_app {

/// The subcommand, which fills `options` when it is parsed.
CLI::App* addSubmit(CLI::App& app, Options& options);

}  // namespace ariadne::experiment_app
