// Lines and numbers of the text formats (TUM, CARMEN).
#pragma once
#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "ariadne/core/numbers.h"

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

using core::parseNumber;

/// The integer that fills the word.
inline std::optional<long> parseInteger(std::string_view word) { return core::parseInteger(word); }

}  // namespace ariadne::io
