#include "ariadne/io/ini_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ariadne::io {
namespace {

/// What the standard parser says of the whole value.
template <class T>
std::errc parseAll(std::string_view text, T& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end != text.data() + text.size()) return std::errc::invalid_argument;
  return error;
}

bool within(double value, const core::Bounds& bounds) {
  return value >= bounds.min && value <= bounds.max;
}

[[noreturn]] void failNumber(const IniEntry& entry, const char* problem, bool whole,
                             const core::Bounds& bounds) {
  throw entryError(entry, fmt::format("{}: it takes {}", problem, takesNumber(whole, bounds)));
}

}  // namespace

std::string takesNumber(bool whole, const core::Bounds& bounds) {
  const char* kind = whole ? "a whole number" : "a number";
  const std::string range = core::describe(bounds);
  return range == "any number" ? kind : fmt::format("{}, {}", kind, range);
}

core::UsageError entryError(const IniEntry& entry, const std::string& what) {
  return core::UsageError(fmt::format("{}: [{}] {} = {}: {}", entry.where, printable(entry.section),
                                      printable(entry.key), printable(entry.value), what));
}

double realOf(const IniEntry& entry, const core::Bounds& bounds) {
  double value = 0;
  const std::errc error = parseAll(entry.value, value);
  if (error == std::errc::result_out_of_range) failNumber(entry, "out of bounds", false, bounds);
  if (error != std::errc() || !std::isfinite(value))
    failNumber(entry, "is no number", false, bounds);
  if (!within(value, bounds)) failNumber(entry, "out of bounds", false, bounds);
  return value;
}

long long wholeOf(const IniEntry& entry, const core::Bounds& bounds) {
  long long value = 0;
  const std::errc error = parseAll(entry.value, value);
  if (error == std::errc::result_out_of_range) failNumber(entry, "out of bounds", true, bounds);
  if (error != std::errc()) failNumber(entry, "is no whole number", true, bounds);
  if (!within(static_cast<double>(value), bounds)) failNumber(entry, "out of bounds", true, bounds);
  return value;
}

bool flagOf(const IniEntry& entry) {
  for (const char* yes : {"true", "yes", "on", "1"})
    if (equalIgnoringCase(entry.value, yes)) return true;
  for (const char* no : {"false", "no", "off", "0"})
    if (equalIgnoringCase(entry.value, no)) return false;
  throw entryError(entry, "it takes true or false");
}

std::size_t choiceOf(const IniEntry& entry, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), entry.value);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw entryError(entry, fmt::format("it takes one of {}; the nearest is \"{}\"",
                                      fmt::join(names, ", "), nearestName(entry.value, names)));
}

core::UsageError unknownSection(const std::string& section, const std::string& where,
                                const std::vector<KnownSection>& known) {
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const KnownSection& k : known) names.push_back(k.name);
  return core::UsageError(fmt::format("{}: [{}]: no such section; the nearest is [{}]", where,
                                      printable(section), nearestName(section, names)));
}

core::UsageError unknownKey(const IniEntry& entry, const std::vector<KnownSection>& known) {
  std::string nearest;
  for (const KnownSection& k : known) {
    if (k.name == entry.section) nearest = nearestName(entry.key, k.keys);
    if (k.name != entry.section &&
        std::find(k.keys.begin(), k.keys.end(), entry.key) != k.keys.end())
      return entryError(entry,
                        fmt::format("no such key in this section: it belongs to [{}]", k.name));
  }
  return entryError(entry, fmt::format("no such key; the nearest is \"{}\"", nearest));
}

}  // namespace ariadne::io
