// INI to parameter structs and back, through the structs' own tables of fields (core/fields.h).
//
// A configuration is any type with a function that calls f(section name, parameter struct&) for
// each of its sections, found by argument-dependent lookup:
//   template <class Config, class F> void forEachSection(Config& config, F&& f);
#pragma once
#include <fmt/format.h>

#include <string>
#include <type_traits>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/core/fields.h"
#include "ariadne/io/ini_text.h"

namespace ariadne::io {

/// The value of an entry as a number (finite, in C notation, nothing behind it), within bounds.
/// Throws core::UsageError that names place, section, key, value and what would be right.
double realOf(const IniEntry& entry, const core::Bounds& bounds);
/// The same for whole numbers; the result fits T.
long long wholeOf(const IniEntry& entry, const core::Bounds& bounds);
/// true, false, yes, no, on, off, 1, 0.
bool flagOf(const IniEntry& entry);
/// Index of the name in `names`.
std::size_t choiceOf(const IniEntry& entry, const std::vector<std::string>& names);

/// "file:3: [section] key = value: what".
core::UsageError entryError(const IniEntry& entry, const std::string& what);

/// "a number, 0 to 1".
std::string takesNumber(bool whole, const core::Bounds& bounds);

/// Names of the choices, in their order.
template <class Enum>
std::vector<std::string> namesOf(const core::Choices<Enum>& choices) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.push_back(choice.first);
  return names;
}

/// The name of a value of an enum.
template <class Enum>
std::string nameOf(Enum value, const core::Choices<Enum>& choices) {
  for (const auto& choice : choices)
    if (choice.second == value) return choice.first;
  throw std::logic_error("an enum value without a name");
}

/// Visitor that puts an entry's value into the field of that key, and knows all keys met.
class FieldSetter {
 public:
  /// Sets the field that this entry names.
  explicit FieldSetter(const IniEntry& entry) : entry_(entry) {}

  /// A number within its bounds, else core::UsageError.
  template <class T>
  void number(const char* key, T& value, const core::Bounds& bounds, const char*) {
    if (!takes(key)) return;
    if constexpr (std::is_integral_v<T>)
      value = static_cast<T>(wholeOf(entry_, bounds));
    else
      value = static_cast<T>(realOf(entry_, bounds));
  }
  /// true or false, else core::UsageError.
  void flag(const char* key, bool& value, const char*) {
    if (takes(key)) value = flagOf(entry_);
  }
  /// Any text.
  void text(const char* key, std::string& value, const char*) {
    if (takes(key)) value = entry_.value;
  }
  /// One of the names, else core::UsageError.
  template <class Enum>
  void choice(const char* key, Enum& value, const core::Choices<Enum>& choices, const char*) {
    if (takes(key)) value = choices[choiceOf(entry_, namesOf(choices))].second;
  }

  /// Whether a field had the entry's key.
  bool found() const { return found_; }
  /// All keys that were visited.
  const std::vector<std::string>& keys() const { return keys_; }

 private:
  bool takes(const char* key) {
    keys_.emplace_back(key);
    if (entry_.key != key) return false;
    found_ = true;
    return true;
  }
  const IniEntry& entry_;
  bool found_ = false;
  std::vector<std::string> keys_;
};

/// What is known of a section's keys, for the message about one that is not.
struct KnownSection {
  std::string name;
  std::vector<std::string> keys;
};
/// To be thrown: names the section, where it stands, and the nearest there is.
core::UsageError unknownSection(const std::string& section, const std::string& where,
                                const std::vector<KnownSection>& known);
/// To be thrown: names the key and the nearest there is, here or in another section.
core::UsageError unknownKey(const IniEntry& entry, const std::vector<KnownSection>& known);

/// Sets the one field that the entry names. Throws core::UsageError when there is none (with the
/// nearest that there is) or when the value does not fit.
template <class Config>
void setField(Config& config, const IniEntry& entry) {
  std::vector<KnownSection> known;
  bool in_section = false;
  bool found = false;
  forEachSection(config, [&](const char* section, auto& params) {
    IniEntry elsewhere;  // collects keys only
    const bool here = entry.section == section;
    FieldSetter setter(here ? entry : elsewhere);
    visitFields(setter, params);
    in_section |= here;
    found |= here && setter.found();
    known.push_back({section, setter.keys()});
  });
  if (!in_section) throw unknownSection(entry.section, entry.where, known);
  if (!found) throw unknownKey(entry, known);
}

/// Sets all fields of a strict document; a section that is not known is an error even when empty.
template <class Config>
void applyIni(Config& config, const IniDocument& document) {
  std::vector<KnownSection> known;
  forEachSection(config, [&](const char* section, auto&) { known.push_back({section, {}}); });
  for (const IniSection& section : document.sections) {
    bool found = false;
    for (const KnownSection& k : known) found |= k.name == section.name;
    if (!found) throw unknownSection(section.name, section.where, known);
  }
  for (const IniEntry& entry : document.entries) setField(config, entry);
}

}  // namespace ariadne::io
