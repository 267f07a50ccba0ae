// YAML by libyaml-cpp, as ROS reads it, with bounds: a file takes memory and time by its size,
// never by what it claims. An alias is another name of the same value, so that nothing is
// multiplied.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ariadne/core/error.h"

namespace ariadne::io {

/// One value of a document: a text, a list, a mapping or nothing. It knows where it stands.
class YamlValue {
 public:
  /// Of a mapping. Throws core::Error when it is none, or lacks the key: the error shows the keys
  /// that are there and `example`, a line that would be right.
  YamlValue at(const std::string& key, const std::string& example) const;
  /// Of a mapping; nothing where it lacks the key. Throws core::Error when it is none.
  std::optional<YamlValue> find(const std::string& key) const;

  /// Of a list. Throws core::Error when it is none.
  std::size_t size() const;
  /// An item of a list. Throws core::Error naming file, line and key.
  YamlValue operator[](std::size_t index) const;

  /// Throw core::Error when the value is another kind of thing.
  std::string text() const;
  double number(double least, double most) const;  ///< no NaN, no infinity
  bool flag() const;                               ///< 0, 1, true, false, and YAML's other words

  /// "map.yaml:3: origin[2]: what"
  core::Error error(const std::string& what) const;

  struct Node;

 private:
  friend YamlValue parseYaml(std::string_view bytes, const std::string& name);
  YamlValue(std::shared_ptr<const Node> node, std::string name, std::string path);
  std::string shown() const;

  std::shared_ptr<const Node> node_;
  std::string name_;  // of the file
  std::string path_;  // of the value in it
};

/// The one document of a file, in any coding that core::plainText() knows.
/// Throws core::Error naming file and line: not YAML, a second document, a key that comes twice,
/// control characters, over 4 MB, 100,000 values or 50 levels.
YamlValue readYaml(const std::filesystem::path& path);

/// The same of bytes; errors call the file `name`.
YamlValue parseYaml(std::string_view bytes, const std::string& name);

}  // namespace ariadne::io
