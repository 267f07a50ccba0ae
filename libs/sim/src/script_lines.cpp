#include "script_lines.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <system_error>

#include "ariadne/core/names.h"
#include "ariadne/core/plain_text.h"

namespace ariadne::sim {
namespace {

constexpr std::size_t kLargestFile = 4U << 20U;

template <class T>
bool parseWhole(std::string_view word, T& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

[[noreturn]] void failNumber(const ScriptLine& line, const std::string& word,
                             const std::string& what, const char* kind,
                             const core::Bounds& bounds) {
  const std::string range = core::describe(bounds);
  throw lineError(line, fmt::format("{} is \"{}\"; it takes {}{}", what, core::printable(word),
                                    kind, range == "any number" ? "" : ", " + range));
}

}  // namespace

std::vector<ScriptLine> scriptLines(std::string_view text, const std::string& name) {
  if (const auto at = text.find('\0'); at != std::string_view::npos)
    throw core::Error(fmt::format("{}: a NUL byte at offset {}: this is no text file", name, at));
  std::vector<ScriptLine> lines;
  std::istringstream in{std::string(text)};
  std::string whole;
  for (int number = 1; std::getline(in, whole); ++number) {
    std::istringstream words(whole.substr(0, whole.find('#')));
    ScriptLine line;
    if (!(words >> line.command)) continue;
    line.number = number;
    line.where = fmt::format("{}:{}", name, number);
    for (std::string word; words >> word;) line.words.push_back(word);
    lines.push_back(std::move(line));
  }
  return lines;
}

namespace {

std::ifstream openForReading(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& why) {
    throw core::Error(fmt::format("cannot read {}: {}", path.string(), why));
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail("it is a folder");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(std::generic_category().message(errno));
  return in;
}

}  // namespace

void expectReadable(const std::filesystem::path& path) { openForReading(path); }

std::string readScript(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  const auto fail = [&](const std::string& why) {
    throw core::Error(fmt::format("cannot read {}: {}", path.string(), why));
  };
  std::string text(kLargestFile + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad()) fail(std::generic_category().message(errno));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kLargestFile) fail("over 4 MB, larger than any world or drive");
  return core::plainText(std::move(text));
}

core::Error lineError(const ScriptLine& line, const std::string& what) {
  return core::Error(fmt::format("{}: {}: {}", line.where, core::printable(line.command), what));
}

core::Error unknownCommand(const ScriptLine& line, const std::vector<std::string>& known) {
  return lineError(line,
                   fmt::format("no such command; there are {}; the nearest is \"{}\"",
                               fmt::join(known, ", "), core::nearestName(line.command, known)));
}

double numberIn(const ScriptLine& line, const std::string& word, const std::string& what,
                const core::Bounds& bounds) {
  double value = 0;
  if (!parseWhole(word, value) || !std::isfinite(value) || value < bounds.min || value > bounds.max)
    failNumber(line, word, what, "a number", bounds);
  return value;
}

long long wholeNumberIn(const ScriptLine& line, const std::string& word, const std::string& what,
                        const core::Bounds& bounds) {
  long long value = 0;
  if (!parseWhole(word, value) || static_cast<double>(value) < bounds.min ||
      static_cast<double>(value) > bounds.max)
    failNumber(line, word, what, "a whole number", bounds);
  return value;
}

void expectWords(const ScriptLine& line, std::size_t count, const std::string& usage) {
  if (line.words.size() != count)
    throw lineError(
        line, fmt::format("{} words follow it; it takes {}: {}", line.words.size(), count, usage));
}

std::vector<double> coordinates(const ScriptLine& line, std::size_t first) {
  constexpr double kFarthest_m = 1e5;
  std::vector<double> values;
  for (std::size_t i = first; i < line.words.size(); ++i)
    values.push_back(numberIn(line, line.words[i], fmt::format("coordinate {}", i + 1 - first),
                              {-kFarthest_m, kFarthest_m}));
  return values;
}

}  // namespace ariadne::sim
