// What libyaml-cpp's parser reports, kept as a tree.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ariadne/io/yaml.h"

namespace ariadne::io {

struct YamlValue::Node {
  enum class Kind { nothing, text, list, mapping };
  Kind kind = Kind::nothing;
  int line = 0;            ///< from 1
  std::size_t levels = 1;  ///< with the deepest of what is in it, through aliases too
  std::string text;
  std::vector<std::shared_ptr<const Node>> items;
  std::vector<std::pair<std::string, std::shared_ptr<const Node>>> members;
};

using YamlNode = YamlValue::Node;

/// Of an UTF-8 text. Throws core::Error naming `name` and the line.
std::shared_ptr<const YamlNode> parseYamlNodes(const std::string& text, const std::string& name);

}  // namespace ariadne::io
