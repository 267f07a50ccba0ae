#include "ariadne/io/ini_writer.h"

#include <algorithm>

namespace ariadne::io {

std::string iniText(const std::string& value) {
  const auto readsBack = [&](const std::string& written) {
    const auto document = parseIni("[s]\nk = " + written + "\n", "", IniDialect::strict);
    return document.entries.size() == 1 && document.entries[0].value == value;
  };
  if (value.find_first_of(std::string("\n\0", 2)) == value.npos) {
    if ((value.empty() || value[0] != '"') && readsBack(value)) return value;
    if (value.find('"') == value.npos) return '"' + value + '"';
  }
  throw core::UsageError(fmt::format("\"{}\" cannot be written to an INI", printable(value)));
}

std::string iniComment(const std::string& text) {
  constexpr std::size_t kWidth = 98;
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t line_end = std::min(text.find('\n', begin), text.size());
    std::size_t end = line_end;
    if (end - begin > kWidth) {
      const std::size_t blank = text.rfind(' ', begin + kWidth);
      if (blank != text.npos && blank > begin) end = blank;
    }
    out += "# " + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return out;
}

std::string markdownText(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (c == '<' || c == '|') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace ariadne::io
