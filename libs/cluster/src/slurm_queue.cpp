#include "ariadne/cluster/slurm_queue.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/process/call.h"

namespace ariadne::cluster {
namespace {

/// Without blanks at their ends.
std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos)
      lines.push_back(line.substr(first, line.find_last_not_of(" \t\r") + 1 - first));
  }
  return lines;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
  return cells;
}

bool isWord(const std::string& text, const char* letters) {
  return !text.empty() && text.find_first_not_of(letters) == std::string::npos;
}

/// A line "17" or "17;cluster", the last such one. Sites write banners around it.
std::string jobIn(const std::string& answer) {
  std::string id;
  for (const std::string& line : linesOf(answer)) {
    const std::size_t end = line.find(';');
    const bool names_cluster = end != std::string::npos;
    if (names_cluster && line.find_first_of(" \t", end) != std::string::npos) continue;
    if (isWord(line.substr(0, end), "0123456789")) id = line.substr(0, end);
  }
  return id;
}

/// The state of "COMPLETED" or "CANCELLED by 1000"; empty for a line of a site's banner.
std::string stateIn(const std::string& line) {
  const std::string state = line.substr(0, line.find(' '));
  const bool is_state = isWord(state, "ABCDEFGHIJKLMNOPQRSTUVWXYZ_");
  return is_state && (state == line || line.find(" by ") == state.size()) ? state : "";
}

std::string problemOf(const std::string& program, const process::CallResult& answer) {
  if (answer.missing) return fmt::format("{} is not here (Debian's package slurm-client)", program);
  if (answer.ok || answer.error.rfind(program + ":", 0) == 0) return answer.ok ? "" : answer.error;
  return fmt::format("{}: {}", program, answer.error);
}

}  // namespace

std::string submitToSlurm(const std::filesystem::path& script) {
  const process::CallResult answer = process::call({"sbatch", "--parsable", script.string()});
  if (answer.missing)
    throw core::UsageError(
        "there is no sbatch in PATH: install Debian's package slurm-client, or take the script of "
        "--script-only to a machine that has it");
  if (!answer.ok) {
    const bool too_many = answer.error.find("array") != std::string::npos;
    throw core::Error(fmt::format(
        "sbatch refused {}: {}{}", script.string(), answer.error,
        too_many ? " (--slices must be less than MaxArraySize of scontrol show config)" : ""));
  }
  if (auto id = jobIn(answer.out); !id.empty()) return id;
  throw core::Error(fmt::format(
      "sbatch tells no job's number in \"{}\": whether {} is with Slurm, squeue says (status)",
      core::printable(answer.out), script.string()));
}

Queue askSqueue(const std::vector<std::string>& names) {
  const process::CallResult answer =
      process::call({"squeue", "--noheader", "--array",
                     fmt::format("--name={}", fmt::join(names, ",")), "--format=%j|%F|%K|%T|%r"});
  Queue queue{problemOf("squeue", answer), {}};
  if (!queue.problem.empty()) return queue;
  for (const std::string& line : linesOf(answer.out)) {
    const auto cells = cellsOf(line);
    if (cells.size() < 4) continue;
    Task task{cells[0], cells[1], 0, cells[3], cells.size() > 4 ? cells[4] : ""};
    const std::string& number = cells[2];
    std::from_chars(number.data(), number.data() + number.size(), task.slice);
    if (task.slice > 0) queue.tasks.push_back(task);
  }
  return queue;
}

Account askSacct(const std::string& id) {
  const process::CallResult answer = process::call(
      {"sacct", "--noheader", "--parsable2", "--allocations", "--jobs=" + id, "--format=State"});
  Account account{problemOf("sacct", answer), {}};
  if (!account.problem.empty()) return account;
  for (const std::string& line : linesOf(answer.out))
    if (const std::string state = stateIn(line); !state.empty()) ++account.states[state];
  return account;
}

}  // namespace ariadne::cluster
