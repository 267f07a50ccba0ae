// The programs an arm may name, each by its description: how it is called, asked for its
// configuration and where it takes its data from. Results are <out>/summary.json of every one.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/batch/experiment.h"

namespace ariadne::batch {

/// Where a program learns of the log that it maps.
enum class TakesDataset { in_config, behind_config, never };

/// What the runner knows of a kind of program. All take CONFIG first and --seed.
struct ProgramDescription {
  const char* name;  ///< in INIs, and of its file; empty: any other program
  TakesDataset dataset = TakesDataset::behind_config;
  bool prints_config = true;  ///< has --print-config and --set
  std::vector<std::string>
      options;                     ///< of a run, not of its result; @out, @threads stand for these
  std::vector<std::string> spare;  ///< further ones where files are not kept
};

/// Those of ours, and at the end the one for any other.
const std::vector<ProgramDescription>& programDescriptions();

/// A program that makes runs.
struct Program {
  std::filesystem::path path;

  /// By the file's name.
  const ProgramDescription& description() const;
};

/// `name` is one of ours (found beside this executable, then in PATH) or a path, from `folder`.
/// Throws core::UsageError at `where` with what there is.
Program findProgram(const std::string& name, const std::filesystem::path& folder,
                    const std::string& where);

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

}  // namespace ariadne::batch
