// INI files as text: lines, sections, keys and raw values, with the place of each for error
// messages.
//
// Own parser: SimpleIni (which MRPT's CConfigFile wraps) keeps no line numbers and merges repeated
// keys and sections without a word, and strict checking needs both.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ariadne/core/names.h"

namespace ariadne::io {

using core::equalIgnoringCase;
using core::nearestName;
using core::printable;

/// `key = value` in a section; `where` is "file:12" or "--set", `value` has no comment.
struct IniEntry {
  std::string section;
  std::string key;
  std::string value;
  std::string where;
};

/// [NAME] of an INI, and in which line.
struct IniSection {
  std::string name;
  std::string where;
};

/// A line that includes another INI.
struct IniInclude {
  std::string file;
  std::string where;
};

/// An INI as it stands, with line numbers and nothing resolved.
struct IniDocument {
  std::string name;                  ///< what errors call the file
  std::vector<IniInclude> includes;  ///< other INIs, whose settings come before these
  std::vector<IniSection> sections;
  std::vector<IniEntry> entries;

  /// Without regard to case, as MRPT looks sections up.
  bool hasSection(std::string_view section) const;
};

/// How a file is read. Both take CRLF, blanks anywhere, no final newline, and lines that are a
/// comment (`;`, `#`, `//`).
enum class IniDialect {
  /// Ours: a comment after a value starts with a blank and `;`, `#` or `//`, a value may stand in
  /// "double quotes"; a section or key that comes twice, a key before any section (but for include)
  /// and a line that is neither are errors.
  strict,
  /// As MRPT reads INIs: a comment after a value starts with a blank and `//`, names have no case,
  /// the last value of a key counts, other lines are skipped.
  mrpt,
};

/// Throws core::UsageError with file and line; also for NUL bytes and lines of more than 64 KB.
IniDocument parseIni(std::string_view text, const std::string& name, IniDialect dialect);

/// The text of a configuration file, made plain by core::plainText. Throws core::Error when it
/// cannot be read and UsageError when it is larger than any (4 MB).
std::string readIniText(const std::filesystem::path& path);

/// The text of `file` in the strict dialect, behind the settings of the INIs that it includes by
/// lines `include = OTHER.ini` before its first section (from its own folder; they may include
/// others). What two of them set is the later one's, and the including one comes last. Names of
/// files in an included INI start where the including one's do. Throws as parseIni() and
/// readIniText().
IniDocument parseIniFile(std::string_view text, const std::filesystem::path& file);

/// `section.key=value` of the option --set. Throws core::UsageError.
IniEntry parseSetting(const std::string& text);

}  // namespace ariadne::io
