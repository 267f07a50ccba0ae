#include "ariadne/batch/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

#include "ariadne/core/error.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::string kConfigWord = "@config";
const std::string kOutWord = "@out";

const std::vector<std::pair<std::string, ProgramKind>>& ours() {
  static const std::vector<std::pair<std::string, ProgramKind>> all = {
      {"ariadne-slam", ProgramKind::maps},
      {"ariadne-explore", ProgramKind::maps},
      {"ariadne-loop-experiment", ProgramKind::loops},
      {"ariadne-stock-rbpf", ProgramKind::stock},
      {"ariadne-stock", ProgramKind::stock}};
  return all;
}

std::string namesOfOurs() {
  std::string names;
  for (const auto& p : ours())
    if (p.first != "ariadne-stock") names += p.first + ", ";
  return names;
}

bool canRun(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
}

/// Where this executable and its sisters are, then PATH.
fs::path search(const std::string& name) {
  std::error_code ignored;
  const fs::path beside = fs::read_symlink("/proc/self/exe", ignored).parent_path() / name;
  return canRun(beside) ? beside : findInPath(name);
}

void append(Words& to, const Words& words) { to.insert(to.end(), words.begin(), words.end()); }

}  // namespace

fs::path findInPath(const std::string& name) {
  const char* path = std::getenv("PATH");
  for (const std::string& folder : splitList(path ? path : "", ":"))
    if (canRun(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
  return {};
}

Program findProgram(const std::string& name, const fs::path& folder, const std::string& where) {
  if (name.find('/') != std::string::npos) {
    const fs::path path = (folder / name).lexically_normal();
    if (!canRun(path))
      throw core::UsageError(
          fmt::format("{}: program = {}: there is no executable {}", where, name, path.string()));
    for (const auto& [own, kind] : ours())
      if (path.filename() == own) return {kind, path};
    return {ProgramKind::other, path};
  }
  for (const auto& [own, kind] : ours()) {
    if (name != own) continue;
    const std::string file = kind == ProgramKind::stock ? "ariadne-stock-rbpf" : own;
    const fs::path path = search(file);
    if (path.empty())
      throw core::UsageError(fmt::format(
          "{}: {} is neither beside ariadne-experiment nor in PATH: build or install it", where,
          file));
    return {kind, path};
  }
  throw core::UsageError(fmt::format("{}: program = {}: takes one of {}or a path with a /", where,
                                     name, namesOfOurs()));
}

Words configCommand(const Program& program, const ArmCall& call) {
  if (program.kind == ProgramKind::stock) return {};
  Words words{program.path.string()};
  if (program.kind == ProgramKind::loops) words.emplace_back("run");
  words.push_back(call.config.string());
  if (!call.dataset.empty()) words.push_back(call.dataset);
  for (const std::string& setting : call.settings) append(words, {"--set", setting});
  append(words, call.args);
  words.emplace_back("--print-config");
  return words;
}

Words runArguments(const Program& program, const ArmCall& call, std::uint64_t seed) {
  const std::string number = std::to_string(seed);
  Words words;
  if (program.kind == ProgramKind::loops)
    words = {"run", kConfigWord, kOutWord + "/rows.csv", "--first", number, "--last", number};
  else
    words = {kConfigWord};
  // Programs that map have it in their resolved INI.
  if (!call.dataset.empty() && program.kind != ProgramKind::maps) words.push_back(call.dataset);
  if (program.kind != ProgramKind::loops) append(words, {"--seed", number});
  append(words, call.args);
  return words;
}

Words runCommand(const Program& program, const Words& arguments, const fs::path& config,
                 const fs::path& out, const Limits& limits) {
  Words words{program.path.string()};
  for (const std::string& a : arguments) {
    if (a == kConfigWord)
      words.push_back(config.string());
    else if (a.compare(0, kOutWord.size(), kOutWord) == 0)
      words.push_back(out.string() + a.substr(kOutWord.size()));
    else
      words.push_back(a);
  }
  if (program.kind == ProgramKind::stock)
    append(words, {"--trajectory", (out / "trajectory.tum").string()});
  if (program.kind == ProgramKind::maps) {
    append(words, {"--threads", std::to_string(limits.threads), "--quiet"});
    if (!limits.keep_files) words.emplace_back("--no-pictures");
  }
  if (program.kind == ProgramKind::maps || program.kind == ProgramKind::other)
    append(words, {"--out", out.string()});
  return words;
}

std::string nameOf(ProgramKind kind) {
  switch (kind) {
    case ProgramKind::maps:
      return "maps";
    case ProgramKind::loops:
      return "loops";
    case ProgramKind::stock:
      return "stock";
    case ProgramKind::other:
      break;
  }
  return "other";
}

ProgramKind kindOf(const std::string& name) {
  for (const ProgramKind kind : {ProgramKind::maps, ProgramKind::loops, ProgramKind::stock})
    if (nameOf(kind) == name) return kind;
  if (name == "other") return ProgramKind::other;
  throw core::Error(fmt::format("\"{}\" is no kind of program", name));
}

}  // namespace ariadne::batch
