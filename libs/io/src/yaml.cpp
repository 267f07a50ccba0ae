#include "ariadne/io/yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "ariadne/core/names.h"
#include "ariadne/core/plain_text.h"
#include "ariadne/io/whole_file.h"
#include "yaml_node.h"

namespace ariadne::io {
namespace {

constexpr std::size_t kMostBytes = 4U << 20U;

using Kind = YamlNode::Kind;

bool beginsWith(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

/// libyaml-cpp takes the byte 4 for the end of the file, without a word.
void expectText(std::string_view text, const std::string& name) {
  int line = 1;
  for (const unsigned char c : text) {
    if (c == '\n') ++line;
    if ((c < ' ' && c != '\n' && c != '\r' && c != '\t') || c == 0x7f)
      throw core::Error(fmt::format("{}:{}: the byte 0x{:02x}: this is no text", name, line, c));
  }
}

std::string keysOf(const YamlNode& node) {
  constexpr std::size_t kMost = 10;
  std::string keys;
  for (std::size_t i = 0; i < std::min(node.members.size(), kMost); ++i)
    keys += (i == 0 ? "" : ", ") + core::printable(node.members[i].first);
  return keys + (node.members.size() > kMost ? ", ..." : "");
}

std::optional<bool> flagOf(const std::string& text) {
  const auto is = [&](const char* word) { return core::equalIgnoringCase(text, word); };
  if (is("1") || is("true") || is("yes") || is("on") || is("y")) return true;
  if (is("0") || is("false") || is("no") || is("off") || is("n")) return false;
  return std::nullopt;
}

}  // namespace

YamlValue::YamlValue(std::shared_ptr<const Node> node, std::string name, std::string path)
    : node_(std::move(node)), name_(std::move(name)), path_(std::move(path)) {}

core::Error YamlValue::error(const std::string& what) const {
  return core::Error(fmt::format("{}:{}: {}{}{}", name_, node_->line, core::printable(path_),
                                 path_.empty() ? "" : ": ", what));
}

std::string YamlValue::shown() const {
  switch (node_->kind) {
    case Kind::text:
      return fmt::format("\"{}\"", core::printable(node_->text));
    case Kind::list:
      return "a list";
    case Kind::mapping:
      return "a mapping";
    default:
      return "nothing";
  }
}

std::optional<YamlValue> YamlValue::find(const std::string& key) const {
  if (node_->kind != Kind::mapping)
    throw error(fmt::format("{} where lines of key: value belong", shown()));
  for (const auto& [name, value] : node_->members)
    if (name == key) return YamlValue(value, name_, path_.empty() ? key : path_ + "." + key);
  return std::nullopt;
}

YamlValue YamlValue::at(const std::string& key, const std::string& example) const {
  if (const auto value = find(key)) return *value;
  throw error(fmt::format("{} is missing, as in {}; there are {}", key, example, keysOf(*node_)));
}

std::size_t YamlValue::size() const {
  if (node_->kind != Kind::list) throw error(fmt::format("{} where a list belongs", shown()));
  return node_->items.size();
}

YamlValue YamlValue::operator[](std::size_t index) const {
  if (index >= size()) throw error(fmt::format("it has {} values, not {}", size(), index + 1));
  return {node_->items[index], name_, fmt::format("{}[{}]", path_, index)};
}

std::string YamlValue::text() const {
  if (node_->kind != Kind::text) throw error(fmt::format("{} where a text belongs", shown()));
  return node_->text;
}

double YamlValue::number(double least, double most) const {
  double value = NAN;
  if (node_->kind == Kind::text) {
    std::string_view word = node_->text;
    if (beginsWith(word, "+") && !beginsWith(word, "+-")) word.remove_prefix(1);
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size()) value = NAN;
  }
  if (value >= least && value <= most && std::isfinite(value)) return value;
  throw error(fmt::format("{}; takes a number from {} to {}", shown(), least, most));
}

bool YamlValue::flag() const {
  if (node_->kind == Kind::text)
    if (const auto value = flagOf(node_->text)) return *value;
  throw error(fmt::format("{}; takes 0, 1, true or false", shown()));
}

YamlValue parseYaml(std::string_view bytes, const std::string& name) {
  const std::string text = core::plainText(std::string(bytes));
  expectText(text, name);
  return {parseYamlNodes(text, name), name, ""};
}

YamlValue readYaml(const std::filesystem::path& path) {
  return parseYaml(readWhole(path, kMostBytes), path.string());
}

}  // namespace ariadne::io
