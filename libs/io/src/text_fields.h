// Lines and numbers of the text formats (TUM, CARMEN), whatever the locale.
#pragma once
#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

namespace ariadne::io {

/// The words of a line, split at blanks; `fields` is reused so that a log costs no allocations.
inline void splitFields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const auto is_blank = [](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  };
  for (auto at = line.begin();;) {
    const auto begin = std::find_if_not(at, line.end(), is_blank);
    if (begin == line.end()) return;
    at = std::find_if(begin, line.end(), is_blank);
    fields.emplace_back(&*begin, static_cast<std::size_t>(at - begin));
  }
}

/// The number that fills the word; "nan" and "inf" are numbers, a number and a rest is none.
inline std::optional<double> parseNumber(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The integer that fills the word.
inline std::optional<long> parseInteger(std::string_view word) {
  long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace ariadne::io
