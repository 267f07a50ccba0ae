#include "ariadne/cluster/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ariadne/batch/content_hash.h"
#include "ariadne/batch/json_numbers.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::cluster {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Submission parse(const fs::path& file) {
  try {
    const Json json = Json::parse(io::readWhole(file));
    Submission s;
    s.number = batch::wholeOf<std::size_t>(json.at("number"), "number");
    s.engine = json.at("engine");
    s.name = json.at("name");
    s.id = json.at("id");
    s.slices = batch::wholeOf<std::size_t>(json.at("slices"), "slices");
    for (const Json& slice : json.at("handed"))
      s.handed.push_back(batch::wholeOf<std::size_t>(slice, "handed"));
    s.plan = json.at("plan");
    if (s.slices < 1) throw core::Error("slices is 0");
    return s;
  } catch (const std::exception& e) {
    throw core::Error(
        fmt::format("{} is no job of ariadne-experiment: {}", file.string(), e.what()));
  }
}

}  // namespace

Submissions::Submissions(fs::path results) : results_(std::move(results)) {}

fs::path Submissions::folder(const Submission& submission) const {
  return results_ / "jobs" / std::to_string(submission.number);
}

Submission Submissions::begin(const std::string& engine) const {
  Submission s;
  s.engine = engine;
  std::error_code error;
  fs::create_directories(results_ / "jobs", error);
  // A folder is made by one only.
  for (s.number = 1; !error && !fs::create_directory(folder(s), error);) ++s.number;
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder(s).string(), error.message()));
  s.name = fmt::format("ariadne-{}-{}", batch::hashOf(results_.string()).substr(0, 8), s.number);
  return s;
}

void Submissions::put(const Submission& s) const {
  const Json json = {{"number", s.number}, {"engine", s.engine}, {"name", s.name}, {"id", s.id},
                     {"slices", s.slices}, {"handed", s.handed}, {"plan", s.plan}};
  io::writeWhole(folder(s) / "job.json", json.dump() + "\n");
}

std::vector<Submission> Submissions::all() const {
  std::vector<Submission> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(results_ / "jobs", ignored))
    if (const fs::path file = entry.path() / "job.json"; fs::exists(file, ignored))
      found.push_back(parse(file));
  std::sort(found.begin(), found.end(),
            [](const Submission& a, const Submission& b) { return a.number < b.number; });
  return found;
}

}  // namespace ariadne::cluster
