#include "ariadne/io/relations.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "ariadne/core/error.h"
#include "input_file.h"
#include "text_fields.h"

namespace ariadne::io {
namespace {

constexpr const char* kForm = "'time1 time2 x y z roll pitch yaw'";

/// Empty when the words are no relation.
std::optional<geometry::Relation> parse(const std::vector<std::string_view>& words) {
  std::array<double, 8> v{};
  if (words.size() != v.size()) return std::nullopt;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto number = parseNumber(words[i]);
    if (!number || !(std::abs(*number) < 1e11)) return std::nullopt;
    v[i] = *number;
  }
  return geometry::Relation{v[0], v[1], {v[2], v[3], v[7]}};
}

}  // namespace

std::vector<geometry::Relation> readRelations(const std::filesystem::path& path) {
  InputFile file(path);
  std::vector<geometry::Relation> relations;
  std::vector<std::string_view> words;
  std::string_view line;
  bool too_long = false;
  for (std::size_t number = 1; file.line(line, too_long); ++number) {
    splitFields(line, words);
    if (words.empty() || words[0][0] == '#') continue;
    const auto relation = too_long ? std::nullopt : parse(words);
    if (!relation)
      throw core::Error(
          fmt::format("{}:{}: expected {}, eight finite numbers", path.string(), number, kForm));
    relations.push_back(*relation);
  }
  if (!file.trouble().empty())
    throw core::Error(fmt::format("{}: {}", path.string(), file.trouble()));
  if (relations.empty())
    throw core::Error(
        fmt::format("{}: no relation in it; expected lines {}", path.string(), kForm));
  return relations;
}

}  // namespace ariadne::io
