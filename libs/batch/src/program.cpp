#include "ariadne/batch/program.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/process/find_program.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string kConfigWord = "@config";
const std::string kOutWord = "@out";
const std::string kThreadsWord = "@threads";

std::string namesOfOurs() {
  std::string names;
  for (const ProgramDescription& d : programDescriptions())
    if (*d.name != '\0') names += std::string(d.name) + ", ";
  return names;
}

void append(Words& to, const Words& words) { to.insert(to.end(), words.begin(), words.end()); }

std::string filledIn(const std::string& word, const fs::path& config, const fs::path& out,
                     const Limits& limits) {
  if (word == kConfigWord) return config.string();
  if (word == kThreadsWord) return std::to_string(limits.threads);
  if (word.compare(0, kOutWord.size(), kOutWord) == 0)
    return out.string() + word.substr(kOutWord.size());
  return word;
}

}  // namespace

const std::vector<ProgramDescription>& programDescriptions() {
  static const Words maps = {"--threads", kThreadsWord, "--quiet", "--out", kOutWord};
  static const std::vector<ProgramDescription> all = {
      {"ariadne-slam", TakesDataset::in_config, true, maps, {"--no-pictures"}},
      {"ariadne-explore", TakesDataset::in_config, true, maps, {"--no-pictures"}},
      {"ariadne-loop-experiment", TakesDataset::never, true, {"--out", kOutWord}, {}},
      {"ariadne-stock-rbpf",
       TakesDataset::behind_config,
       false,
       {"--trajectory", kOutWord + "/trajectory.tum", "--summary", kOutWord + "/summary.json"},
       {}},
      {"", TakesDataset::behind_config, true, {"--out", kOutWord}, {}}};
  return all;
}

const ProgramDescription& Program::description() const {
  for (const ProgramDescription& d : programDescriptions())
    if (path.filename() == d.name) return d;
  return programDescriptions().back();
}

Program findProgram(const std::string& name, const fs::path& folder, const std::string& where) {
  if (name.find('/') != std::string::npos) {
    const fs::path path = (folder / name).lexically_normal();
    if (process::canRun(path)) return {path};
    throw core::UsageError(
        fmt::format("{}: program = {}: there is no executable {}", where, name, path.string()));
  }
  for (const ProgramDescription& d : programDescriptions()) {
    if (name.empty() || name != d.name) continue;
    const fs::path path = process::findSister(name);
    if (!path.empty()) return {path};
    throw core::UsageError(
        fmt::format("{}: {} is neither beside ariadne-experiment nor in PATH: build or install it",
                    where, name));
  }
  throw core::UsageError(fmt::format("{}: program = {}: takes one of {}or a path with a /", where,
                                     name, namesOfOurs()));
}

Words configCommand(const Program& program, const ArmCall& call) {
  if (!program.description().prints_config) return {};
  Words words{program.path.string(), call.config.string()};
  if (!call.dataset.empty()) words.push_back(call.dataset);
  for (const std::string& setting : call.settings) append(words, {"--set", setting});
  append(words, call.args);
  words.emplace_back("--print-config");
  return words;
}

Words runArguments(const Program& program, const ArmCall& call, std::uint64_t seed) {
  Words words{kConfigWord};
  // Programs that map have it in their resolved INI.
  if (!call.dataset.empty() && program.description().dataset == TakesDataset::behind_config)
    words.push_back(call.dataset);
  append(words, {"--seed", std::to_string(seed)});
  append(words, call.args);
  return words;
}

Words runCommand(const Program& program, const Words& arguments, const fs::path& config,
                 const fs::path& out, const Limits& limits) {
  Words words = arguments;
  append(words, program.description().options);
  if (!limits.keep_files) append(words, program.description().spare);
  for (std::string& word : words) word = filledIn(word, config, out, limits);
  words.insert(words.begin(), program.path.string());
  return words;
}

}  // namespace ariadne::batch
