#include "carmen_fans.h"

#include <fmt/format.h>

#include <algorithm>

namespace ariadne::io {
namespace {

constexpr std::size_t kMostKinds = 16;  // damaged lines may all differ

}  // namespace

CarmenFans::Kind CarmenFans::kindOf(const CarmenScan& scan) {
  const CarmenLineFan fan = scan.fan.value_or(CarmenLineFan());
  return {scan.record.scan->sensorLabel, scan.record.beams.ranges_m.size(), fan.start, fan.field,
          fan.step};
}

FanChoice CarmenFans::choose(const Kind& kind) const {
  const auto& [label, count, start, field, step] = kind;
  if (count < 2) return {CarmenFan(), "", {}, ""};
  const bool bare = label == "FLASER" || label == "RLASER";
  const auto line = bare ? std::nullopt : std::optional(CarmenLineFan{start, field, step});
  const auto met = met_.find(kind);
  const bool looks_round = met != met_.end() && met->second.looksRound();
  return chooseFan(label, count, line, params_.of(label), field_of_view_deg_, looks_round);
}

void CarmenFans::meet(const CarmenScan& scan) {
  const Kind kind = kindOf(scan);
  if (met_.size() < kMostKinds || met_.count(kind) > 0) met_[kind].add(scan.record.beams.ranges_m);
}

bool CarmenFans::allKnown(const std::function<bool(const std::string&)>& is_used) const {
  return std::all_of(met_.begin(), met_.end(), [&](const auto& met) {
    return !is_used(std::get<0>(met.first)) || choose(met.first).fan;
  });
}

const FanChoice& CarmenFans::of(const CarmenScan& scan, std::vector<std::string>& notes,
                                std::vector<std::string>& remarks) {
  const Kind kind = kindOf(scan);
  const auto there = choices_.find(kind);
  if (there != choices_.end()) return there->second;
  if (choices_.size() >= kMostKinds) return other_ = choose(kind);
  const FanChoice& choice = choices_[kind] = choose(kind);
  const std::string& label = std::get<0>(kind);
  const std::size_t count = std::get<1>(kind);
  for (const std::string& remark : choice.remarks)
    remarks.push_back(fmt::format("{} lines: {}", label, remark));
  if (!choice.fan || count < 2) return choice;
  const double first = choice.fan->start_rad * 180 / M_PI;
  const double last = first + choice.fan->step_rad * 180 / M_PI * (static_cast<double>(count) - 1);
  notes.push_back(fmt::format("{}: {} beams from {:.5g} to {:.5g} degrees, {}", label, count, first,
                              last, choice.source));
  return choice;
}

}  // namespace ariadne::io
