#include "carmen_line_fan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ariadne::io {
namespace {

constexpr double kDegree_rad = M_PI / 180;
constexpr double kWidest_rad = kWidestFan_deg * kDegree_rad;

/// The largest angle that the line names.
double widest(const CarmenLineFan& line, double gaps) {
  return std::max({std::abs(line.start), std::abs(line.field), gaps * std::abs(line.step)});
}

std::string asText(const CarmenLineFan& line) {
  return fmt::format("start angle {:g}, field of view {:g}, resolution {:g}", line.start,
                     line.field, line.step);
}

/// Whether a fan of this span, perhaps without its left end, lies about the laser's axis.
bool isCentred(double start, double span, double step) {
  return std::abs(2 * std::abs(start) - std::abs(span)) < 2.5 * std::abs(step);
}

/// The step, where the line names the field of view alone.
double stepOfField(const CarmenLineFan& line, std::size_t count) {
  const auto gaps = static_cast<double>(count) - 1;
  // The field may or may not count the missing left end of an even number of beams.
  const CarmenFan round = fanOfField(std::abs(line.field) / kDegree_rad, count);
  const double step =
      std::abs(std::abs(round.start_rad) - std::abs(line.start)) < 1e-3 || line.start == 0
          ? round.step_rad
          : std::abs(line.field) / gaps;
  return std::copysign(step, line.field);
}

}  // namespace

bool isClockwise(const CarmenLineFan& line) {
  return line.step < 0 || (line.step == 0 && line.field < 0);
}

LineFanReading readLineFan(const CarmenLineFan& line, std::size_t count) {
  const auto gaps = static_cast<double>(count) - 1;
  LineFanReading out;
  CarmenLineFan fan = line;
  if (fan.step == 0 && fan.field == 0) return out;
  if (widest(fan, gaps) > kWidest_rad) {
    fan = {fan.start * kDegree_rad, fan.field * kDegree_rad, fan.step * kDegree_rad};
    out.remark = fmt::format("{} are taken for degrees", asText(line));
    if (widest(fan, gaps) > kWidest_rad) {
      out.remark = fmt::format("{} are impossible for {} beams", asText(line), count);
      return out;
    }
  }
  if (fan.step == 0) {
    const double step = stepOfField(fan, count);
    const double start = fan.start != 0 ? fan.start : -fan.field / 2;
    out.fan = CarmenFan{start, step};
    return out;
  }
  if (fan.field * fan.step < 0) {
    // A fan about the laser's axis says the direction by its start; else the resolution does.
    if (fan.start * fan.step > 0 && isCentred(fan.start, gaps * fan.step, fan.step))
      fan.step = -fan.step;
    else
      fan.field = -fan.field;
    out.remark = fmt::format("{}: the signs contradict each other; taken for {}", asText(line),
                             fan.step < 0 ? "clockwise" : "counterclockwise");
  }
  // With or without the missing left end, and with rounded numbers.
  const bool agree =
      fan.field == 0 || std::abs(gaps * fan.step - fan.field) < 1.6 * std::abs(fan.step);
  if (!agree) {
    const double step = fan.field / gaps;
    const bool by_field =
        isCentred(fan.start, fan.field, step) && !isCentred(fan.start, gaps * fan.step, fan.step);
    out.remark = fmt::format("{} contradict each other with {} beams; the {} is used", asText(line),
                             count, by_field ? "field of view" : "resolution");
    if (by_field) fan.step = step;
  }
  out.fan = CarmenFan{fan.start, fan.step};
  return out;
}

}  // namespace ariadne::io
