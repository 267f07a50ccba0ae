#include "yaml_node.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "ariadne/core/names.h"

namespace ariadne::io {
namespace {

constexpr std::size_t kMostValues = 100000;
constexpr std::size_t kMostLevels = 50;

using Kind = YamlNode::Kind;
using NodePtr = std::shared_ptr<YamlNode>;

/// Builds the tree of one document from the parser's events.
class Builder : public YAML::EventHandler {
 public:
  explicit Builder(const std::string& name) : name_(name) {}

  NodePtr take() { return std::move(root_); }
  bool started() const { return started_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (started_) fail(mark, "a second document begins here; one is read");
    started_ = true;
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(mark, made(mark, anchor, Kind::nothing));
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    const NodePtr node = made(mark, anchor, Kind::text);
    node->text = value;
    add(mark, node);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const NodePtr node = anchors_[anchor];
    for (const Open& o : open_)
      if (o.node == node) fail(mark, "an alias of the value that it stands in");
    expectFewLevels(mark, node->levels);
    add(mark, node);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, made(mark, anchor, Kind::list));
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, made(mark, anchor, Kind::mapping));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    NodePtr node;
    NodePtr key;                      // of a mapping, while its value is awaited
    std::map<std::string, int> seen;  // keys with their lines
  };

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw core::Error(fmt::format("{}:{}: {}", name_, mark.line + 1, what));
  }

  NodePtr made(const YAML::Mark& mark, YAML::anchor_t anchor, Kind kind) {
    if (++values_ > kMostValues) fail(mark, fmt::format("over {} values", kMostValues));
    auto node = std::make_shared<YamlNode>();
    node->kind = kind;
    node->line = mark.line + 1;
    if (anchor != YAML::NullAnchor) anchors_[anchor] = node;
    return node;
  }

  void open(const YAML::Mark& mark, const NodePtr& node) {
    expectFewLevels(mark, 1);
    add(mark, node);
    open_.push_back({node, nullptr, {}});
  }

  void close() {
    const NodePtr node = open_.back().node;
    open_.pop_back();
    if (!open_.empty()) deepen(node);
  }

  /// What is open holds `node`.
  void deepen(const NodePtr& node) {
    std::size_t& levels = open_.back().node->levels;
    levels = std::max(levels, node->levels + 1);
  }

  /// A tree is freed level by level, on the stack.
  void expectFewLevels(const YAML::Mark& mark, std::size_t more) const {
    if (open_.size() + more > kMostLevels) fail(mark, fmt::format("over {} levels", kMostLevels));
  }

  /// Puts a value into what is open: a list, or a mapping, where keys and values take turns.
  void add(const YAML::Mark& mark, const NodePtr& node) {
    if (open_.empty()) {
      root_ = node;
      return;
    }
    Open& in = open_.back();
    deepen(node);
    if (in.node->kind == Kind::list) {
      in.node->items.push_back(node);
    } else if (in.key) {
      if (node->kind == Kind::nothing) node->line = in.key->line;  // else that of what follows
      in.node->members.emplace_back(in.key->text, node);
      in.key = nullptr;
    } else {
      addKey(mark, in, node);
    }
  }

  void addKey(const YAML::Mark& mark, Open& in, const NodePtr& key) {
    if (key->kind == Kind::list || key->kind == Kind::mapping)
      fail(mark, "a list or a mapping as a key; a key is a word, as in resolution: 0.05");
    const auto [before, is_new] = in.seen.emplace(key->text, mark.line + 1);
    if (!is_new)
      fail(mark, fmt::format("{} comes twice, first in line {}", core::printable(key->text),
                             before->second));
    in.key = key;
  }

  const std::string& name_;
  bool started_ = false;
  std::size_t values_ = 0;
  NodePtr root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, NodePtr> anchors_;
};

}  // namespace

std::shared_ptr<const YamlNode> parseYamlNodes(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  Builder builder(name);
  try {
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& e) {
    throw core::Error(
        fmt::format("{}:{}: this is no YAML: {}", name, e.mark.line + 1, core::printable(e.msg)));
  }
  if (auto root = builder.take()) return root;
  throw core::Error(
      fmt::format("{}: there is nothing in it; a YAML has lines of key: value", name));
}

}  // namespace ariadne::io
