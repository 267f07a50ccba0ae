#include "ariadne/batch/store.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "owner.h"
#include "plan_json.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

bool isThere(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

void create(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

void writeIfOther(const fs::path& file, const std::string& text) {
  if (!isThere(file) || io::readWhole(file) != text) io::writeWhole(file, text);
}

}  // namespace

Store::Store(fs::path folder) : folder_(fs::absolute(folder).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();
}

void Store::refuseOthers(const Plan& plan) const {
  if (!isThere(folder_)) return;
  std::error_code error;
  if (!fs::is_directory(folder_, error))
    throw core::UsageError(fmt::format("{} is no folder: name another", folder_.string()));
  if (isThere(folder_ / "plan.json")) {
    const std::string there = readPlan().title;
    if (there != plan.title)
      throw core::UsageError(fmt::format(
          "{} holds the results of \"{}\", not of \"{}\": name another folder with --out",
          folder_.string(), there, plan.title));
    return;
  }
  // A start that was stopped before the plan was written leaves only these.
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    if (name == "configs" || name == "runs" || name == "claims" || name[0] == '.') continue;
    if (isThere(folder_ / "plan.json")) return refuseOthers(plan);  // another wrote it just now
    throw core::UsageError(fmt::format(
        "{} holds files and no plan.json of an experiment: name a new or empty folder with --out",
        folder_.string()));
  }
}

void Store::writePlan(const Plan& plan) const {
  refuseOthers(plan);
  for (const char* part : {"configs", "runs", "claims"}) create(folder_ / part);
  probe();
  for (const auto& [hash, text] : plan.configs) writeIfOther(config(hash), text);
  writeIfOther(folder_ / "plan.json", planText(plan));
}

Plan Store::readPlan() const {
  const fs::path file = folder_ / "plan.json";
  if (!isThere(file))
    throw core::UsageError(fmt::format(
        "{} is no results folder of ariadne-experiment: it has no plan.json", folder_.string()));
  return parsePlan(io::readWhole(file), file.string());
}

fs::path Store::file(const std::string& key) const { return folder_ / "runs" / (key + ".json"); }

fs::path Store::config(const std::string& hash) const {
  return folder_ / "configs" / (hash + ".ini");
}

fs::path Store::scratch(const std::string& owner) const { return folder_ / "scratch" / owner; }

bool Store::has(const std::string& key) const { return isThere(file(key)); }

std::optional<RunResult> Store::result(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return parseResult(io::readWhole(file(key)), file(key).string());
}

std::map<std::string, RunResult> Store::results(const Plan& plan) const {
  std::map<std::string, RunResult> all;
  for (const PlannedRun& run : plan.runs) {
    if (all.count(run.key) > 0) continue;
    if (auto one = result(run.key)) all.emplace(run.key, std::move(*one));
  }
  return all;
}

void Store::put(const RunResult& result) const {
  // Two machines may have done the same run when one was taken for dead.
  if (!result.failure.empty() && has(result.key)) return;
  io::writeWhole(file(result.key), resultText(result));
}

void Store::forget(const std::string& key) const {
  std::error_code ignored;
  fs::remove(file(key), ignored);
}

void Store::clearAfter(const std::string& owner) const {
  std::error_code ignored;
  fs::remove_all(scratch(owner), ignored);
  const OwnerParts parts = partsOf(owner);
  const std::string mark = parts.pid + "-" + parts.start;
  for (const fs::path& place : {folder_, folder_ / "configs", folder_ / "runs"})
    for (const auto& entry : fs::directory_iterator(place, ignored)) {
      const std::string name = entry.path().filename().string();
      // io::writeWhole's temporary names and ours
      if (name[0] == '.' &&
          (name.find("." + mark + ".part") != std::string::npos || name == ".probe-" + mark))
        fs::remove(entry.path(), ignored);
    }
}

void Store::probe() const {
  const fs::path probe = folder_ / (".probe-" + io::writerMark());
  io::writeWhole(probe, std::string(65536, 'x'));
  std::error_code ignored;
  fs::remove(probe, ignored);
}

}  // namespace ariadne::batch
