#include "ros_map_file.h"

#include <fmt/format.h>
#include <mrpt/img/CImage.h>

#include <charconv>
#include <cmath>
#include <map>
#include <string>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "map_checks.h"
#include "script_lines.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) + 1 - first));
}

/// What follows `key:`, without quotes and comment.
std::string valueOf(std::string_view rest) {
  const std::string text = trimmed(rest);
  if (!text.empty() && (text[0] == '"' || text[0] == '\'')) {
    std::string value;
    for (std::size_t i = 1; i < text.size() && text[i] != text[0]; ++i) {
      if (text[0] == '"' && text[i] == '\\' && i + 1 < text.size()) ++i;
      value += text[i];
    }
    return value;
  }
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t'))
      return trimmed(text.substr(0, i));
  return text;
}

/// The flat mapping that a map's YAML is; a list may stand in [] or below its key behind dashes.
class Values {
 public:
  explicit Values(const std::string& text) {
    std::string last;
    for (std::size_t begin = 0, number = 1; begin < text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = trimmed(std::string_view(text).substr(begin, end - begin));
      begin = end + 1;
      if (line.empty() || line[0] == '#' || line[0] == '%' || line == "---") continue;
      if (line.rfind("- ", 0) == 0 && !last.empty()) {
        values_[last] += "," + valueOf(line.substr(2));
        continue;
      }
      const std::size_t colon = line.find(':');
      if (colon == line.npos)
        throw core::Error(fmt::format("line {}: \"{}\" is not key: value, as image: map.pgm",
                                      number, core::printable(line)));
      last = trimmed(line.substr(0, colon));
      values_[last] = valueOf(line.substr(colon + 1));
    }
  }

  const std::string& text(const char* key) const {
    const auto found = values_.find(key);
    if (found == values_.end() || found->second.empty())
      throw core::Error(fmt::format("{} is missing", key));
    return found->second;
  }
  bool has(const char* key) const { return values_.count(key) > 0; }

  /// The `index`-th of a list, or the number itself.
  double number(const char* key, std::size_t index, double low, double high) const {
    std::string_view list = text(key);
    for (std::size_t i = 0;; ++i) {
      list.remove_prefix(std::min(list.find_first_not_of("[, \t"), list.size()));
      const std::size_t end = std::min(list.find_first_of("], \t"), list.size());
      double value = NAN;
      const auto read = std::from_chars(list.data(), list.data() + end, value);
      if (i == index && read.ec == std::errc() && read.ptr == list.data() + end && value >= low &&
          value <= high)
        return value;
      if (i == index || end == 0)
        throw core::Error(fmt::format("{}: {}: takes a number from {} to {}", key,
                                      core::printable(text(key)), low, high));
      list.remove_prefix(end);
    }
  }

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace

mrpt::maps::COccupancyGridMap2D readRosMap(const std::filesystem::path& yaml) {
  const Values values(readScript(yaml));
  if (values.has("mode") && values.text("mode") != "trinary" && values.text("mode") != "scale")
    throw core::Error(
        fmt::format("mode: {}: trinary and scale are read", core::printable(values.text("mode"))));
  const double resolution_m = values.number("resolution", 0, 0.005, 0.5);
  const double left = values.number("origin", 0, -1e5, 1e5);
  const double bottom = values.number("origin", 1, -1e5, 1e5);
  const bool negate = values.has("negate") && values.number("negate", 0, 0, 1) != 0;
  const double free_thresh =
      values.has("free_thresh") ? values.number("free_thresh", 0, 0, 1) : 0.196;
  const std::filesystem::path picture = yaml.parent_path() / values.text("image");
  expectPictureCells(picture);
  mrpt::img::CImage image;
  if (!image.loadFromFile(picture.string(), 0))
    throw core::Error(fmt::format("its image {} cannot be read", picture.string()));
  const auto columns = static_cast<int>(image.getWidth());
  const auto rows = static_cast<int>(image.getHeight());
  const auto f = [](double value) { return static_cast<float>(value); };
  mrpt::maps::COccupancyGridMap2D map(f(left), f(left + columns * resolution_m), f(bottom),
                                      f(bottom + rows * resolution_m), f(resolution_m));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double bright =
          image.at<std::uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y)) / 255.0;
      map.setCell(x, rows - 1 - y, (negate ? bright : 1 - bright) < free_thresh ? kFree : kRock);
    }
  return map;
}

}  // namespace ariadne::sim
