// A configuration as text: an INI that reads back to the same values, and a page that explains it.
#pragma once
#include <fmt/format.h>

#include <string>
#include <vector>

#include "ariadne/io/ini_fields.h"

namespace ariadne::io {

/// A text value so that parseIni() gives it back: quoted where a comment or blanks would be lost.
/// Throws core::UsageError when that is impossible (a line break; a quote and a comment).
std::string iniText(const std::string& value);

/// "# " before each line of the text, wrapped to 100 columns.
std::string iniComment(const std::string& text);

/// Without what Markdown would take for markup: `<`, `|`.
std::string markdownText(const std::string& text);

/// One field as the writers see it.
struct WrittenField {
  std::string key;
  std::string value;
  std::string help;
  std::string takes;  ///< "a number, 0 to 1"; "one of a, b"
};

/// Visitor that collects all fields of a parameter struct; doubles with the fewest digits that read
/// back to the same bits.
class FieldCollector {
 public:
  /// With the bounds as help.
  template <class T>
  void number(const char* key, T& value, const core::Bounds& bounds, const char* help) {
    fields.push_back(
        {key, fmt::format("{}", value), help, takesNumber(std::is_integral_v<T>, bounds)});
  }
  /// As true or false.
  void flag(const char* key, bool& value, const char* help) {
    fields.push_back({key, value ? "true" : "false", help, "true or false"});
  }
  /// As it stands, or in quotes where it must.
  void text(const char* key, std::string& value, const char* help) {
    fields.push_back({key, iniText(value), help, "text"});
  }
  /// By its name, with all names as help.
  template <class Enum>
  void choice(const char* key, Enum& value, const core::Choices<Enum>& choices, const char* help) {
    fields.push_back({key, nameOf(value, choices), help,
                      fmt::format("one of {}", fmt::join(namesOf(choices), ", "))});
  }
  std::vector<WrittenField> fields;
};

/// Calls f(section name, its fields) for each section.
template <class Config, class F>
void forEachWrittenSection(Config config, F&& f) {
  forEachSection(config, [&](const char* section, auto& params) {
    FieldCollector collector;
    visitFields(collector, params);
    f(section, collector.fields);
  });
}

/// The whole configuration, each key explained above it; `header` is a comment before all.
template <class Config>
std::string writeIni(const Config& config, const std::string& header) {
  std::string out = iniComment(header);
  forEachWrittenSection(config, [&](const char* section, const std::vector<WrittenField>& fields) {
    out += fmt::format("\n[{}]\n", section);
    for (const WrittenField& f : fields) {
      out += iniComment(f.takes == "text" ? f.help : fmt::format("{} ({})", f.help, f.takes));
      out += fmt::format("{} = {}\n", f.key, f.value);
    }
  });
  return out;
}

/// The same as tables in Markdown, with the values as defaults.
template <class Config>
std::string writeMarkdown(const Config& config, const std::string& header) {
  std::string out = header;
  forEachWrittenSection(config, [&](const char* section, const std::vector<WrittenField>& fields) {
    out += fmt::format("\n## [{}]\n\n| key | default | takes | meaning |\n|---|---|---|---|\n",
                       section);
    for (const WrittenField& f : fields)
      out += fmt::format("| `{}` | {} | {} | {} |\n", f.key,
                         f.value.empty() ? "" : fmt::format("`{}`", f.value), f.takes,
                         markdownText(f.help));
  });
  return out;
}

}  // namespace ariadne::io
