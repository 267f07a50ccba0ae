// The command lines of the subcommands that need no log.
#pragma once
#include <CLI/CLI.hpp>

#include "simulate.h"

namespace ariadne {

/// Both fill `args`, which must outlive the app; the caller sets what they run.
CLI::App* declareSimulate(CLI::App& app, SimulateArguments& args);
CLI::App* declareWorld(CLI::App& app, SimulateArguments& args);

}  // namespace ariadne
