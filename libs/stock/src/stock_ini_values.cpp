#include "stock_ini_values.h"

#include <charconv>
#include <cmath>

#include "ariadne/io/ini_fields.h"

namespace ariadne::stock {

using namespace io;  // its INIs are read as ours are

namespace {

std::string firstWord(const std::string& text) {
  return text.substr(0, text.find_first_of("[], \t"));  // MRPT's separators
}

}  // namespace

double mrptNumber(const IniEntry& entry) {
  std::string_view text = entry.value;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value))
    throw entryError(entry, "it takes a number");
  return value;
}

int mrptInteger(const IniEntry& entry) {
  const double value = mrptNumber(entry);
  if (std::abs(value) > 2147483647.0) throw entryError(entry, "out of bounds");
  return static_cast<int>(value);
}

bool mrptBool(const IniEntry& entry) {
  const std::string word = firstWord(entry.value);
  for (const char* yes : {"true", "yes"})
    if (equalIgnoringCase(word, yes)) return true;
  for (const char* no : {"false", "no"})
    if (equalIgnoringCase(word, no)) return false;
  return mrptNumber(entry) != 0;
}

std::size_t mrptEnum(const IniEntry& entry, const std::vector<std::string>& names) {
  const std::string word = firstWord(entry.value);
  for (std::size_t i = 0; i < names.size(); ++i)
    if (word == names[i] || word == std::to_string(i)) return i;
  throw entryError(entry,
                   fmt::format("it takes one of {}, or 0 to {}; the nearest is \"{}\"",
                               fmt::join(names, ", "), names.size() - 1, nearestName(word, names)));
}

}  // namespace ariadne::stock
