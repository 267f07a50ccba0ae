#include "ariadne/io/ros_options.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "text_fields.h"

namespace ariadne::io {

std::optional<LaserPose> parseLaserPose(const std::string& text, const std::string& where) {
  std::vector<std::string_view> words;
  splitFields(text, words);
  if (words.empty()) return std::nullopt;
  LaserPose place;
  const auto isNumber = [](std::string_view word, double& value) {
    const auto parsed = parseNumber(word);
    if (parsed) value = *parsed;
    return parsed && std::abs(value) <= 1000;
  };
  const bool numbers = words.size() >= 3 && isNumber(words[0], place.x_m) &&
                       isNumber(words[1], place.y_m) && isNumber(words[2], place.yaw_deg);
  place.upside_down = words.size() == 4 && words[3] == "upside_down";
  if (!numbers || words.size() > 4 || (words.size() == 4 && !place.upside_down))
    throw core::UsageError(
        fmt::format("{} = {}: it takes x and y in m and the yaw in degrees, as in \"0.2 0 -90\", "
                    "and upside_down behind them for a laser that hangs",
                    where, text));
  return place;
}

}  // namespace ariadne::io
