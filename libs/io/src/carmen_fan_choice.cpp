#include "carmen_fan_choice.h"

#include <fmt/format.h>

#include <cmath>

#include "carmen_line_fan.h"

namespace ariadne::io {
namespace {

constexpr double kDegrees = 180 / M_PI;

bool isPossible(double span_deg) {
  return span_deg >= kNarrowestFan_deg && span_deg <= kWidestFan_deg;
}

/// The number as degrees, or as radians where only these are possible: no field of view is so
/// small that both are. nullopt: neither is possible. `beams` fields make the whole.
std::optional<double> degreesOf(const std::optional<CarmenParam>& param, double beams) {
  if (!param) return std::nullopt;
  const double whole = std::abs(param->value) * beams;
  if (isPossible(whole)) return param->value;
  if (isPossible(whole * kDegrees)) return param->value * kDegrees;
  return std::nullopt;
}

/// Fans that a source names, perhaps none.
struct Source {
  std::optional<CarmenFan> fan;
  std::string name;
  std::vector<std::string> remarks;
};

Source byParams(std::size_t count, const CarmenLaserParams& params) {
  const auto step_deg = degreesOf(params.resolution, static_cast<double>(count) - 1);
  const auto field_deg = degreesOf(params.field, 1);
  Source source;
  const auto refuse = [&](const std::optional<CarmenParam>& param, bool usable) {
    if (param && !usable)
      source.remarks.push_back(fmt::format("{} is not possible with {} beams", param->text, count));
  };
  refuse(params.resolution, step_deg.has_value());
  refuse(params.field, field_deg.has_value());
  if (step_deg) {
    source.fan = fanOfStep(std::abs(*step_deg), count);
    if (*step_deg < 0) source.fan = mirrored(*source.fan);
    source.name = "by " + params.resolution->text;
  }
  if (!field_deg) return source;
  const CarmenFan of_field = fanOfField(std::abs(*field_deg), count);
  if (!step_deg) {
    source.fan = *field_deg < 0 ? mirrored(of_field) : of_field;
    source.name = "by " + params.field->text;
  } else if (!areAlike(*source.fan, of_field, count)) {
    const std::string both = fmt::format("{} and {} contradict each other with {} beams",
                                         params.resolution->text, params.field->text, count);
    const auto known = knownFan(count);
    if (known && areAlike(of_field, *known, count)) {
      source.fan = of_field;
      source.name = "by " + params.field->text;
    } else if (!known || !areAlike(*source.fan, *known, count)) {
      source.fan.reset();
    }
    source.remarks.push_back(both);
  }
  return source;
}

Source bySetting(std::size_t count, const std::optional<CarmenLineFan>& line, double setting_deg) {
  Source source;
  if (!(setting_deg > 0)) return source;
  source.fan = fanOfField(setting_deg, count);
  if (line && isClockwise(*line)) source.fan = mirrored(*source.fan);
  source.name = fmt::format("by field_of_view_deg = {:g}", setting_deg);
  return source;
}

Source byLine(std::size_t count, const std::optional<CarmenLineFan>& line) {
  Source source;
  if (!line) return source;
  const LineFanReading reading = readLineFan(*line, count);
  source.fan = reading.fan;
  source.name = "by its lines";
  if (!reading.remark.empty()) source.remarks.push_back(reading.remark);
  return source;
}

Source byCount(std::size_t count) {
  return {knownFan(count), fmt::format("as with every SICK of {} beams", count), {}};
}

std::string problemOf(const std::string& label, std::size_t count, const CarmenLaserParams& params,
                      const std::vector<std::string>& remarks, bool looks_round) {
  const char* what =
      looks_round
          ? "their first and last beams see the same, as with a laser that looks all round, "
            "while SICKs with so many span 180 or 100 degrees"
          : "nothing in the log says over what angle";
  std::string text = fmt::format(
      "{} lines have {} beams, and {} (no PARAM laser_{}_laser_resolution); say it: [dataset] "
      "field_of_view_deg, as in --set dataset.field_of_view_deg={}, or ariadne-dataset's "
      "--field-of-view",
      label, count, what, params.rear ? "rear" : "front", looks_round ? 360 : 270);
  for (const std::string& remark : remarks) text += "; " + remark;
  return text;
}

}  // namespace

FanChoice chooseFan(const std::string& label, std::size_t count,
                    const std::optional<CarmenLineFan>& line, const CarmenLaserParams& params,
                    double setting_deg, bool looks_round) {
  FanChoice choice;
  // The last one holds only where nothing else does, so it contradicts nobody.
  const Source sources[] = {bySetting(count, line, setting_deg), byLine(count, line),
                            byParams(count, params)};
  for (const Source& source : sources) {
    choice.remarks.insert(choice.remarks.end(), source.remarks.begin(), source.remarks.end());
    if (!source.fan) continue;
    if (!choice.fan) {
      choice.fan = source.fan;
      choice.source = source.name;
    } else if (!areAlike(*choice.fan, *source.fan, count)) {
      choice.remarks.push_back(fmt::format("{:.5g} degrees {} are used, not {:.5g} degrees {}",
                                           spanOf(*choice.fan, count), choice.source,
                                           spanOf(*source.fan, count), source.name));
    }
  }
  if (choice.fan) return choice;
  const Source known = byCount(count);
  if (!looks_round) choice.fan = known.fan;
  choice.source = known.name;
  if (!choice.fan)
    choice.problem = problemOf(label, count, params, choice.remarks, known.fan.has_value());
  return choice;
}

}  // namespace ariadne::io
