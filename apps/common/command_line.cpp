#include "command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"

namespace ariadne::app {
namespace {

using Names = std::vector<std::string>;

/// "--seed", "-w", ... of one (sub)command.
Names optionsOf(const CLI::App& app) {
  Names names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

Names subcommandsOf(const CLI::App& app) {
  Names names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Of an option that was not expected.
std::string wrongOption(const CLI::App& app, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const auto parsed = app.get_subcommands();
  const CLI::App& in = parsed.empty() ? app : *parsed.back();
  if (&in != &app && has(optionsOf(in), name))
    return fmt::format("{} belongs behind {}", name, in.get_name());
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    if (has(optionsOf(*sub), name))
      return fmt::format("{} is an option of {}{}", name, sub->get_name(),
                         &in == &app ? "" : ", not of " + in.get_name());
  return fmt::format("there is no option {}; the nearest is {}", core::printable(name),
                     core::nearestName(name, optionsOf(in)));
}

/// Empty when CLI11 has said it.
std::string problemOf(const CLI::App& app) {
  const Names left = app.remaining(true);
  for (const std::string& word : left)
    if (word.size() > 1 && word[0] == '-' && word != "--") return wrongOption(app, word);
  if (app.get_require_subcommand_min() == 0 || !app.get_subcommands().empty()) return "";
  const Names known = subcommandsOf(app);
  if (left.empty()) return fmt::format("which subcommand? There are {}", fmt::join(known, ", "));
  return fmt::format("there is no subcommand \"{}\"; the nearest is {}", core::printable(left[0]),
                     core::nearestName(left[0], known));
}

}  // namespace

bool parseCommandLine(CLI::App& app, const std::vector<std::string>& args, std::ostream& out) {
  app.set_version_flag("--version", ARIADNE_VERSION);
  try {
    app.parse(Names(args.rbegin(), args.rend()));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) {
      app.exit(e, out, out);
      return false;
    }
    const std::string problem = problemOf(app);
    throw core::UsageError(
        fmt::format("{} (see {} --help)", problem.empty() ? e.what() : problem, app.get_name()));
  }
  return true;
}

}  // namespace ariadne::app
