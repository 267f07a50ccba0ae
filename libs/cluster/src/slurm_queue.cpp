#include "ariadne/cluster/slurm_queue.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "ariadne/cluster/called.h"
#include "ariadne/core/error.h"

namespace ariadne::cluster {
namespace {

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '|');) cells.push_back(cell);
  return cells;
}

std::string problemOf(const std::string& program, const Called& called) {
  if (called.missing) return fmt::format("{} is not here (Debian's package slurm-client)", program);
  if (called.ok || called.error.rfind(program + ":", 0) == 0) return called.ok ? "" : called.error;
  return fmt::format("{}: {}", program, called.error);
}

}  // namespace

std::string submitToSlurm(const std::filesystem::path& script) {
  const Called called = call({"sbatch", "--parsable", script.string()});
  if (called.missing)
    throw core::UsageError(
        "there is no sbatch in PATH: install Debian's package slurm-client, or take the script of "
        "--script-only to a machine that has it");
  if (!called.ok) {
    const bool too_many = called.error.find("array") != std::string::npos;
    throw core::Error(fmt::format(
        "sbatch refused {}: {}{}", script.string(), called.error,
        too_many ? " (--slices must be less than MaxArraySize of scontrol show config)" : ""));
  }
  return called.out.substr(0, called.out.find_first_of(";\n"));  // "17" or "17;cluster"
}

Queue askSqueue(const std::vector<std::string>& names) {
  const Called called =
      call({"squeue", "--noheader", "--array", fmt::format("--name={}", fmt::join(names, ",")),
            "--format=%j|%F|%K|%T|%r"});
  Queue queue{problemOf("squeue", called), {}};
  if (!queue.problem.empty()) return queue;
  std::istringstream lines(called.out);
  for (std::string line; std::getline(lines, line);) {
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
  const Called called = call(
      {"sacct", "--noheader", "--parsable2", "--allocations", "--jobs=" + id, "--format=State"});
  Account account{problemOf("sacct", called), {}};
  std::istringstream lines(account.problem.empty() ? called.out : "");
  // "CANCELLED by 1000": the state is the first word.
  for (std::string line; std::getline(lines, line);)
    ++account.states[line.substr(0, line.find(' '))];
  return account;
}

}  // namespace ariadne::cluster
