#include "ariadne/io/log_or_ini.h"

#include <algorithm>
#include <string>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/core/plain_text.h"
#include "input_file.h"

namespace ariadne::io {
namespace {

constexpr std::size_t kPreamble = 64 << 10;  // longer than any INI's comment
constexpr std::string_view kLeading = " \t\v\f\r";

/// Without leading blanks; empty for a comment.
std::string_view contentOf(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(kLeading), line.size()));
  const bool comment =
      line.substr(0, 1) == "#" || line.substr(0, 1) == ";" || line.substr(0, 2) == "//";
  return comment ? std::string_view() : line;
}

/// `[section]` or `key = value`.
bool isOfIni(std::string_view content) {
  if (content[0] == '[') return true;
  const std::size_t key_end = std::min(content.find_first_of(" \t="), content.size());
  const std::size_t next = content.find_first_not_of(kLeading, key_end);
  return next != content.npos && content[next] == '=';
}

bool isText(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 32 && c != '\n' && kLeading.find(c) == kLeading.npos;
  });
}

bool beginsLikeLog(std::string_view text) {
  if (!isText(text)) return true;
  const char line_end = core::lineEnd(text);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find(line_end));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (const auto content = contentOf(line); !content.empty()) return !isOfIni(content);
  }
  return false;
}

}  // namespace

bool looksLikeLog(const std::filesystem::path& path) {
  if (core::equalIgnoringCase(path.extension().string(), ".ini")) return false;
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) return true;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  try {
    InputFile file(path);
    return beginsLikeLog(file.peek(kPreamble).substr(0, kPreamble));
  } catch (const core::Error&) {
    return false;
  }
}

}  // namespace ariadne::io
