#include "ariadne/io/ini_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>

#include "ariadne/core/error.h"
#include "ariadne/core/plain_text.h"

namespace ariadne::io {
namespace {

constexpr std::size_t kMaxLine = 64 << 10;
constexpr std::size_t kMaxFile = 4 << 20;
constexpr std::string_view kBlanks = " \t\v\f\r";

std::string_view trimmed(std::string_view s) {
  const std::size_t begin = s.find_first_not_of(kBlanks);
  if (begin == s.npos) return {};
  return s.substr(begin, s.find_last_not_of(kBlanks) + 1 - begin);
}

bool isBlank(char c) { return kBlanks.find(c) != kBlanks.npos; }

bool startsComment(std::string_view s, IniDialect dialect) {
  if (s.substr(0, 2) == "//") return true;
  return dialect == IniDialect::strict && !s.empty() && (s[0] == ';' || s[0] == '#');
}

/// Without the comment behind it: one that starts after a blank, so that paths may hold `//`.
std::string_view withoutComment(std::string_view s, IniDialect dialect) {
  for (std::size_t i = 0; i < s.size(); ++i)
    if ((i == 0 || isBlank(s[i - 1])) && startsComment(s.substr(i), dialect))
      return trimmed(s.substr(0, i));
  return trimmed(s);
}

class Parser {
 public:
  Parser(const std::string& name, IniDialect dialect) : dialect_(dialect) { document_.name = name; }

  void line(std::string_view raw, std::size_t number) {
    number_ = number;
    if (raw.size() > kMaxLine) fail("the line is longer than 64 KB: no configuration file");
    if (raw.find('\0') != raw.npos) fail("holds a NUL byte: a configuration is plain text");
    const std::string_view text = trimmed(raw);
    if (text.empty() || text[0] == ';' || text[0] == '#' || text.substr(0, 2) == "//") return;
    if (text[0] == '[')
      section(text);
    else
      entry(text);
  }

  IniDocument take() { return std::move(document_); }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw core::UsageError(fmt::format("{}: {}", where(), what));
  }
  std::string where() const { return fmt::format("{}:{}", document_.name, number_); }
  bool strict() const { return dialect_ == IniDialect::strict; }

  void section(std::string_view text) {
    const std::size_t close = text.find(']');
    const std::string name(trimmed(text.substr(1, close == text.npos ? text.npos : close - 1)));
    if (strict()) {
      if (close == text.npos || name.empty())
        fail(fmt::format("\"{}\" is no [section]", printable(text)));
      if (!withoutComment(text.substr(close + 1), dialect_).empty())
        fail(fmt::format("something follows the section: \"{}\"", printable(text)));
    } else if (close == text.npos) {
      return;
    }
    const auto [before, is_new] = places_.emplace("[" + name, number_);
    if (!is_new && strict())
      fail(fmt::format("section [{}] comes twice, first in line {}: merge the two", printable(name),
                       before->second));
    section_ = name;
    inside_ = true;
    document_.sections.push_back({name, where()});
  }

  void entry(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string key(trimmed(text.substr(0, equals)));
    if (equals == text.npos || key.empty()) {
      if (!strict()) return;
      fail(fmt::format("\"{}\" is neither [section] nor key = value", printable(text)));
    }
    if (strict() && !inside_ && key == "include") return include(value(text.substr(equals + 1)));
    if (strict() && !inside_)
      fail(fmt::format("\"{}\" stands before any [section]", printable(key)));
    const auto [before, is_new] = places_.emplace(section_ + "]" + key, number_);
    if (!is_new && strict())
      fail(fmt::format("[{}] {} comes twice, first in line {}: keep one", section_, printable(key),
                       before->second));
    document_.entries.push_back({section_, key, value(text.substr(equals + 1)), where()});
  }

  void include(const std::string& file) {
    if (file.empty()) fail("include takes the name of an INI");
    document_.includes.push_back({file, where()});
  }

  std::string value(std::string_view text) const {
    text = trimmed(text);
    if (!strict() || text.empty() || text[0] != '"')
      return std::string(withoutComment(text, dialect_));
    const std::size_t close = text.find('"', 1);
    if (close == text.npos) fail(fmt::format("no closing quote in {}", printable(text)));
    if (!withoutComment(text.substr(close + 1), dialect_).empty())
      fail(fmt::format("something follows the quoted value: {}", printable(text)));
    return std::string(text.substr(1, close - 1));
  }

  IniDialect dialect_;
  IniDocument document_;
  std::size_t number_ = 0;
  std::string section_;
  bool inside_ = false;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

bool IniDocument::hasSection(std::string_view section) const {
  return std::any_of(sections.begin(), sections.end(),
                     [&](const IniSection& s) { return equalIgnoringCase(s.name, section); });
}

IniDocument parseIni(std::string_view text, const std::string& name, IniDialect dialect) {
  Parser parser(name, dialect);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    parser.line(text.substr(0, end), number);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.take();
}

std::string readIniText(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw core::Error(fmt::format("cannot read {}: it is a folder", path.string()));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  char block[1 << 14];
  while (file && text.size() <= kMaxFile) {
    file.read(block, sizeof(block));
    text.append(block, static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad())
    throw core::Error(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
  if (text.size() > kMaxFile)
    throw core::UsageError(
        fmt::format("{} is larger than 4 MB: no configuration file", path.string()));
  return core::plainText(std::move(text));
}

IniEntry parseSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.find('.');
  if (equals == text.npos || dot == text.npos || dot > equals)
    throw core::UsageError(fmt::format(
        "--set {}: takes section.key=value, as in --set filter.particles=50", printable(text)));
  const std::string_view view = text;
  return {std::string(trimmed(view.substr(0, dot))),
          std::string(trimmed(view.substr(dot + 1, equals - dot - 1))),
          std::string(trimmed(view.substr(equals + 1))), "--set"};
}

}  // namespace ariadne::io
