#include "ariadne/sim/drive_path.h"

#include <fmt/format.h>

#include <algorithm>

#include "script_lines.h"

namespace ariadne::sim {
namespace {

constexpr double kMost = 1e6;

/// A waypoint, or a mark when it has a name.
struct Item {
  Waypoint waypoint;
  std::string mark;
};

struct OpenBlock {
  ScriptLine line;  // the `repeat`
  std::size_t times = 1;
  std::vector<Item> items;
};

class Parser {
 public:
  Parser(const std::string& name, std::optional<int> laps) : given_laps_(laps) {
    path_.name = name;
    blocks_.emplace_back();
  }

  void read(const ScriptLine& line) {
    if (line.command == "goto") {
      expectWords(line, 2, "goto x y");
      const auto at = coordinates(line);
      add(line, {{{at[0], at[1]}, line.number}, {}});
    } else if (line.command == "mark") {
      expectWords(line, 1, "mark NAME");
      add(line, {{}, markName(line)});
    } else if (line.command == "repeat") {
      expectWords(line, 1, "repeat N, or: repeat laps");
      blocks_.push_back({line, timesOf(line), {}});
    } else if (line.command == "end") {
      close(line);
    } else if (line.command == "laps") {
      expectWords(line, 1, "laps N");
      if (file_laps_) throw lineError(line, "a second one; a drive has one");
      file_laps_ = countIn(line, "the number of laps");
    } else {
      throw unknownCommand(line, {"goto", "repeat", "end", "mark", "laps"});
    }
  }

  DrivePath finish() {
    if (blocks_.size() > 1)
      throw lineError(blocks_.back().line,
                      "its block is open at the end of the file; `end` closes "
                      "it");
    for (const Item& item : blocks_.front().items)
      if (item.mark.empty())
        path_.waypoints.push_back(item.waypoint);
      else
        path_.marks.push_back({item.mark, path_.waypoints.size()});
    if (path_.waypoints.empty())
      throw core::Error(path_.name + ": no waypoint; a drive has one line `goto x y` at least");
    path_.laps = given_laps_.value_or(file_laps_.value_or(0));
    return std::move(path_);
  }

 private:
  static int countIn(const ScriptLine& line, const char* what) {
    return static_cast<int>(wholeNumberIn(line, line.words[0], what, {0, kMost}));
  }

  /// Names go into tables of comma-separated values.
  static std::string markName(const ScriptLine& line) {
    const std::string& name = line.words[0];
    if (name.find_first_of(",\"") != std::string::npos)
      throw lineError(line, "a name takes no comma and no quote");
    return name;
  }

  std::size_t timesOf(const ScriptLine& line) {
    if (line.words[0] != "laps")
      return static_cast<std::size_t>(countIn(line, "the number of times"));
    path_.has_laps_block = true;
    const auto laps = given_laps_ ? given_laps_ : file_laps_;
    if (!laps)
      throw lineError(line, "the number of laps is not set; a line `laps N` above sets it");
    return static_cast<std::size_t>(*laps);
  }

  void add(const ScriptLine& line, Item item) {
    checkRoom(line, 1);
    blocks_.back().items.push_back(std::move(item));
  }

  void close(const ScriptLine& line) {
    expectWords(line, 0, "end");
    if (blocks_.size() == 1) throw lineError(line, "there is no `repeat` that it could close");
    const OpenBlock block = std::move(blocks_.back());
    blocks_.pop_back();
    checkRoom(line, static_cast<double>(block.times) * static_cast<double>(block.items.size()));
    auto& items = blocks_.back().items;
    for (std::size_t i = 0; i < block.times; ++i)
      items.insert(items.end(), block.items.begin(), block.items.end());
  }

  /// Before memory is taken, since blocks multiply.
  void checkRoom(const ScriptLine& line, double more) const {
    const double all = static_cast<double>(blocks_.back().items.size()) + more;
    if (all > kMost)
      throw lineError(
          line, fmt::format("{:.0f} waypoints and marks; a drive has {:.0f} at most", all, kMost));
  }

  DrivePath path_;
  std::optional<int> given_laps_;
  std::optional<int> file_laps_;
  std::vector<OpenBlock> blocks_;
};

}  // namespace

DrivePath parsePath(std::string_view text, const std::string& name, std::optional<int> laps) {
  if (laps && (*laps < 0 || *laps > kMost))
    throw core::UsageError(fmt::format("{} laps; 0 to {:.0f} can be driven", *laps, kMost));
  Parser parser(name, laps);
  for (const ScriptLine& line : scriptLines(text, name)) parser.read(line);
  return parser.finish();
}

DrivePath readPath(const std::filesystem::path& path, std::optional<int> laps) {
  return parsePath(readScript(path), path.string(), laps);
}

}  // namespace ariadne::sim
