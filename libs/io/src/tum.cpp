#include "ariadne/io/tum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "text_fields.h"

namespace ariadne::io {
namespace {

constexpr double kLatestTum_s = 1e11;  // the year 5138; nanoseconds since 1970 are beyond it
constexpr double kFarthestTum_m = 1e8;

/// The pose of a line's words; on failure `problem` says what is wrong.
bool parsePose(const std::vector<std::string_view>& words, geometry::StampedPose& out,
               std::string& problem) {
  std::array<double, 8> v{};
  if (words.size() != v.size()) {
    problem = fmt::format("{} numbers", words.size());
    return false;
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto number = parseNumber(words[i]);
    if (!number || !std::isfinite(*number)) {
      problem = fmt::format("'{}'", words[i].substr(0, 40));
      return false;
    }
    v[i] = *number;
  }
  const auto [t, x, y, z, qx, qy, qz, qw] = v;
  const double largest = std::max({std::abs(qx), std::abs(qy), std::abs(qz), std::abs(qw)});
  if (std::abs(t) > kLatestTum_s) problem = fmt::format("time {} (seconds since 1970?)", words[0]);
  if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > kFarthestTum_m)
    problem = fmt::format("a place over {:g} m away", kFarthestTum_m);
  if (largest < 1e-6 || largest > 1e6) problem = "a quaternion that is no rotation";
  if (!problem.empty()) return false;
  // Yaw of a quaternion of any length.
  const double yaw = std::atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
  out = {t, {x, y, yaw}};
  return true;
}

}  // namespace

geometry::Trajectory readTum(const std::filesystem::path& path) {
  const std::string content = readText(path);
  geometry::Trajectory trajectory;
  std::vector<std::string_view> words;
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    const std::string_view line = std::string_view(content).substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    splitFields(line, words);
    if (words.empty() || words[0][0] == '#') continue;
    geometry::StampedPose pose;
    std::string problem;
    if (!parsePose(words, pose, problem))
      throw core::Error(fmt::format("{}:{}: expected 'time x y z qx qy qz qw', found {}",
                                    path.string(), line_number, problem));
    trajectory.push_back(pose);
  }
  if (trajectory.empty())
    throw core::Error(
        fmt::format("{}: no pose in it; expected lines 'time x y z qx qy qz qw'", path.string()));
  return geometry::sortedByTime(std::move(trajectory));
}

void writeTum(const std::filesystem::path& path, const geometry::Trajectory& trajectory,
              const std::vector<std::string>& header) {
  std::string text;
  auto out = std::back_inserter(text);
  for (const std::string& line : header) fmt::format_to(out, "# {}\n", line);
  for (const auto& [time_s, pose] : trajectory)
    fmt::format_to(out, "{:.7f} {:.9f} {:.9f} 0 0 0 {:.12f} {:.12f}\n", time_s, pose.x, pose.y,
                   std::sin(pose.phi / 2), std::cos(pose.phi / 2));
  writeWhole(path, text);
}

}  // namespace ariadne::io
