// Numbers of text, whatever the locale.
#pragma once
#include <charconv>
#include <optional>
#include <string_view>

namespace ariadne::core {

/// The number that fills the word; "nan" and "inf" are numbers, a number and a rest is none.
inline std::optional<double> parseNumber(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The whole number that fills the word.
template <class T = long>
std::optional<T> parseInteger(std::string_view word) {
  T value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace ariadne::core
