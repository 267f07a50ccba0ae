#include "ariadne/batch/config_differences.h"

#include <algorithm>
#include <functional>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"

namespace ariadne::batch {
namespace {

using Values = std::vector<std::string>;

io::IniDocument parsed(const std::string& text) {
  try {
    return io::parseIni(text, "", io::IniDialect::strict);
  } catch (const core::UsageError&) {
    return {};  // another program's, in a dialect of its own
  }
}

/// Each key's values by arm, each value once, in the order of the arm's runs.
class Keys {
 public:
  explicit Keys(std::size_t arms) : arms_(arms) {}

  void add(const std::string& key, std::size_t arm, const std::string& value) {
    const auto [at, is_new] = values_.emplace(key, std::vector<Values>(arms_));
    if (is_new) order_.push_back(key);
    Values& known = at->second[arm];
    if (std::find(known.begin(), known.end(), value) == known.end()) known.push_back(value);
  }

  std::vector<KeyDifference> differences() const {
    std::vector<KeyDifference> all;
    for (const std::string& key : order_) {
      const auto& values = values_.at(key);
      if (std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end())
        continue;
      all.push_back({key, {}});
      for (const Values& of_arm : values) all.back().values.push_back(joined(of_arm, ", "));
    }
    return all;
  }

  static std::string joined(const Values& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
  }

 private:
  std::size_t arms_;
  std::vector<std::string> order_;
  std::map<std::string, std::vector<Values>> values_;
};

}  // namespace

std::vector<KeyDifference> differencesOf(const Plan& plan,
                                         const std::map<std::string, std::string>& configs) {
  Keys keys(plan.arms.size());
  std::map<std::string, io::IniDocument> documents;
  for (const auto& [hash, text] : configs) documents[hash] = parsed(text);
  for (std::size_t arm = 0; arm < plan.arms.size(); ++arm)
    keys.add("program", arm, plan.arms[arm].program.path.filename().string());
  for (const PlannedRun& run : plan.runs) {
    if (run.seed != plan.runs.front().seed) break;  // the others are alike
    keys.add("arguments", run.arm, Keys::joined(run.arguments, " "));
  }
  for (const PlannedRun& run : plan.runs) {
    if (run.seed != plan.runs.front().seed) break;
    const auto document = documents.find(run.config);
    if (document == documents.end()) continue;
    for (const io::IniEntry& e : document->second.entries)
      if (e.section != "run") keys.add(e.section + "." + e.key, run.arm, e.value);
  }
  return keys.differences();
}

}  // namespace ariadne::batch
