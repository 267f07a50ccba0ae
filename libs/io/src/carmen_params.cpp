#include "carmen_params.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "text_fields.h"

namespace ariadne::io {
namespace {

using Spelling = std::pair<std::string_view, const char*>;

constexpr std::array<Spelling, 9> kLasers = {{{"front_laser_", "front"},
                                              {"frontlaser_", "front"},
                                              {"rear_laser_", "rear"},
                                              {"rearlaser_", "rear"},
                                              {"laser1_", "laser1"},
                                              {"laser2_", "laser2"},
                                              {"laser3_", "laser3"},
                                              {"laser4_", "laser4"},
                                              {"laser5_", "laser5"}}};
constexpr std::array<Spelling, 12> kQuantities = {{{"resolution", "resolution"},
                                                   {"angular_resolution", "resolution"},
                                                   {"fov", "field"},
                                                   {"field_of_view", "field"},
                                                   {"max", "max"},
                                                   {"max_range", "max"},
                                                   {"maxrange", "max"},
                                                   {"maximum_range", "max"},
                                                   {"offset", "ahead"},
                                                   {"side_offset", "left"},
                                                   {"angular_offset", "turn"},
                                                   {"id", "id"}}};

/// "laser_front_laser_resolution" is "front resolution"; empty: of no interest.
std::string keyOf(std::string_view name) {
  const std::string_view module = name.substr(0, 6);
  if (module != "laser_" && module != "robot_") return {};
  name.remove_prefix(module.size());
  for (const auto& [spelled, laser] : kLasers) {
    if (name.substr(0, spelled.size()) != spelled) continue;
    for (const auto& [word, quantity] : kQuantities)
      if (name.substr(spelled.size()) == word) return fmt::format("{} {}", laser, quantity);
  }
  return {};
}

}  // namespace

std::optional<std::string> CarmenParams::take(const std::vector<std::string_view>& words,
                                              Place place) {
  if (words.size() < 3) return std::nullopt;
  const std::string key = keyOf(words[1]);
  const auto number = parseNumber(words[2]);
  if (key.empty() || !number || !std::isfinite(*number)) return std::nullopt;
  const CarmenParam param{fmt::format("PARAM {} {}", words[1], words[2].substr(0, 40)), *number};
  const auto [there, is_new] = values_.try_emplace(key);
  Value& value = there->second;
  if (place == Place::header || (is_new && place == Place::among)) {
    value.param = param;
  } else if (value.param.value != *number && !std::exchange(value.remarked, true)) {
    const std::string used = value.param.text;
    return fmt::format("{} comes after the first scans and is not used{}", param.text,
                       used.empty() ? "" : ", but " + used);
  }
  return std::nullopt;
}

std::optional<CarmenParam> CarmenParams::find(const std::string& laser, const char* what) const {
  for (const std::string& name : {laser, deviceOf(laser)}) {
    const auto found = values_.find(fmt::format("{} {}", name, what));
    if (found != values_.end() && !found->second.param.text.empty()) return found->second.param;
  }
  return std::nullopt;
}

/// The front and the rear laser are devices with a number, too.
std::string CarmenParams::deviceOf(const std::string& laser) const {
  if (laser != "front" && laser != "rear") return laser;
  const auto id = values_.find(laser + " id");
  if (id != values_.end()) return fmt::format("laser{:.0f}", id->second.param.value);
  return laser == "front" ? "laser1" : "laser2";
}

std::string CarmenParams::laserOf(const std::string& label) const {
  if (label == "FLASER") return "front";
  if (label == "RLASER") return "rear";
  const char number = label.back();
  if (label.rfind("RAWLASER", 0) != 0) {  // ROBOTLASERs are numbered by their place, not by device
    if (number == '1') return "front";
    if (number == '2') return "rear";
  }
  const std::string device = fmt::format("laser{}", number);
  if (device == deviceOf("front")) return "front";
  return device == deviceOf("rear") ? "rear" : device;
}

CarmenLaserParams CarmenParams::of(const std::string& label) const {
  const std::string laser = laserOf(label);
  CarmenLaserParams params;
  params.rear = laser == "rear";
  params.resolution = find(laser, "resolution");
  params.field = find(laser, "field");
  params.max_range_m = find(laser, "max");
  params.ahead_m = find(laser, "ahead");
  params.left_m = find(laser, "left");
  params.turn = find(laser, "turn");
  return params;
}

}  // namespace ariadne::io
