#include "ariadne/batch/success.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ariadne/io/ini_fields.h"

namespace ariadne::batch {

std::vector<std::string> splitList(const std::string& text, const char* separators) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    const std::size_t first = text.find_first_not_of(" \t", begin);
    if (first < end) {
      const std::size_t last = text.find_last_not_of(" \t", end - 1);
      words.push_back(text.substr(first, last + 1 - first));
    }
    begin = end + 1;
  }
  return words;
}

std::optional<double> valueOf(const Figures& figures, const std::string& name) {
  const auto found = figures.find(name);
  if (found == figures.end() || std::isnan(found->second)) return std::nullopt;
  return found->second;
}

Judgement Success::of(const Figures& figures) const {
  const auto found = figures.find(figure);
  if (found == figures.end()) return Judgement::no_success;
  const double value = found->second;
  if (std::isnan(value)) return Judgement::unjudged;
  bool holds = value != bound;
  if (relation == "<=") holds = value <= bound;
  if (relation == ">=") holds = value >= bound;
  if (relation == "<") holds = value < bound;
  if (relation == ">") holds = value > bound;
  return holds ? Judgement::success : Judgement::no_success;
}

std::string Success::text() const {
  return relation == "!=" ? figure : fmt::format("{} {} {}", figure, relation, bound);
}

Success parseSuccess(const io::IniEntry& entry) {
  Success success;
  const std::size_t at = entry.value.find_first_of("<>=!");
  const auto name = splitList(entry.value.substr(0, at), " \t");
  if (name.size() != 1)
    throw io::entryError(entry, "takes a figure, or one with a bound: ate_rmse_m <= 0.5");
  success.figure = name[0];
  if (at == std::string::npos) return success;
  const std::size_t end = std::min(entry.value.find_first_not_of("<>=!", at), entry.value.size());
  success.relation = entry.value.substr(at, end - at);
  if (success.relation != "<=" && success.relation != ">=" && success.relation != "<" &&
      success.relation != ">")
    throw io::entryError(entry, "compares with <=, >=, < or >, as in ate_rmse_m <= 0.5");
  io::IniEntry bound = entry;
  const auto rest = splitList(entry.value.substr(end), " \t");
  bound.value = rest.size() == 1 ? rest[0] : "";
  success.bound = io::realOf(bound, {});
  return success;
}

}  // namespace ariadne::batch
