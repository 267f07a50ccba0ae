// Command lines read alike by all programs.
#pragma once
#include <CLI/CLI.hpp>
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne::app {

/// Adds --version, and parses. Says false when the program is done already: --help and --version
/// are printed to `out`, and its exit code is 0. Throws core::UsageError that says what is wrong,
/// and what option or subcommand is nearest to one that there is not.
/// @param args without the program's name
bool parseCommandLine(CLI::App& app, const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::app
