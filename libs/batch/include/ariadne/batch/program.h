// The programs an arm may name: how each is called and asked for its configuration.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/batch/experiment.h"

namespace ariadne::batch {

enum class ProgramKind {
  maps,   ///< CONFIG [DATASET] --seed --out, summary.json: ariadne-slam, ariadne-explore
  loops,  ///< ariadne-loop-experiment: run CONFIG rows.csv --first --last
  stock,  ///< ariadne-stock-rbpf CONFIG RAWLOG --seed --trajectory; figures from what it prints
  other,  ///< a program of the user's, with the options of `maps` that results depend on
};

struct Program {
  ProgramKind kind = ProgramKind::other;
  std::filesystem::path path;
};

/// `name` is one of ours (found beside this executable, then in PATH) or a path, from `folder`.
/// Throws core::UsageError at `where` with what there is.
Program findProgram(const std::string& name, const std::filesystem::path& folder,
                    const std::string& where);

/// An executable of the environment's PATH; empty when there is none of that name.
std::filesystem::path findInPath(const std::string& name);

/// One arm at one combination of the factors' values, as the program takes it; paths absolute.
struct ArmCall {
  std::filesystem::path config;
  std::string dataset;
  std::vector<std::string> settings;  ///< section.key=value
  std::vector<std::string> args;
};

/// What prints the resolved INI; empty for a program that cannot.
std::vector<std::string> configCommand(const Program& program, const ArmCall& call);

/// What makes the run's result: all but where it is written and what does not change it. @config
/// stands for the resolved INI (settings are in it already), @out for the run's folder.
std::vector<std::string> runArguments(const Program& program, const ArmCall& call,
                                      std::uint64_t seed);

/// The whole command of a run.
std::vector<std::string> runCommand(const Program& program,
                                    const std::vector<std::string>& arguments,
                                    const std::filesystem::path& config,
                                    const std::filesystem::path& out, const Limits& limits);

/// As in plan.json.
std::string nameOf(ProgramKind kind);
ProgramKind kindOf(const std::string& name);

}  // namespace ariadne::batch
