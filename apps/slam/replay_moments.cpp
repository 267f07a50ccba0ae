#include "replay_moments.h"

#include <fmt/format.h>

#include <cctype>

namespace ariadne::slam_app {
namespace {

using report::MomentKind;
using report::ReplayMoment;

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

ReplayMoment detectionOf(const loops::ClosingRecord& record) {
  const loops::Closing& c = record.closing;
  const loops::LoopOpportunity& o = c.opportunity;
  ReplayMoment m{c.detected, MomentKind::detection, fmt::format("Loop {} detected", c.id), {}, {}};
  m.text = fmt::format("Its entry is {:.1f} m away by the map and {:.1f} m by the graph.",
                       o.dist_m_m, o.dist_g_m);
  m.table = {{"what", "value"},
             {"places in I(s*), Eq. (7)", fmt::format("{}", o.places.size())},
             {"dist_m to the entry", fmt::format("{:.2f} m", o.dist_m_m)},
             {"dist_G to the entry", fmt::format("{:.2f} m", o.dist_g_m)},
             {"entry", fmt::format("({:.2f}, {:.2f}) m", c.entry_position.x, c.entry_position.y)},
             {"te, Eq. (9)", fmt::format("update {}", o.te)},
             {"length of the loop", fmt::format("{:.1f} m", c.course.loop_length_m)}};
  if (record.saving) {
    m.table.push_back({"saved particles", fmt::format("{}", record.saving->entries)});
    m.table.push_back(
        {"distinct ancestors at te",
         fmt::format("{} of {}", record.saving->distinct_ancestors, record.saving->existed)});
  }
  return m;
}

ReplayMoment endOf(const loops::ClosingRecord& record) {
  const loops::Closing& c = record.closing;
  ReplayMoment m{*c.ended, MomentKind::end, {}, sentence(c.end_reason), {}};
  m.title = fmt::format(c.entered ? "Loop {}: closing ended" : "Loop {} given up", c.id);
  if (!record.note.empty()) m.text += fmt::format(" No recovery: {}.", record.note);
  const auto rule = [&](const char* name, const std::optional<double>& after_m) {
    if (after_m) m.table.push_back({name, fmt::format("{:.1f} m after the entry", *after_m)});
  };
  rule("the rule on Neff would end it", c.neff_rule_m);
  rule("the rule on the slope of ln Neff", c.slope_rule_m);
  if (!m.table.empty()) m.table.insert(m.table.begin(), {"what", "value"});
  return m;
}

ReplayMoment recoveryOf(const loops::ClosingRecord& record) {
  const loops::RecoveryRecord& r = *record.recovery;
  ReplayMoment m{r.update,
                 MomentKind::recovery,
                 fmt::format("Loop {}: diversity recovered", record.closing.id),
                 {},
                 {}};
  m.text = fmt::format("Distinct ancestors at te: {} before, {} after.", r.distinct_before,
                       r.distinct_after);
  m.table = {{"what", "value"},
             {"paths through the loop that were drawn", fmt::format("{}", r.distinct_sources)},
             {"wall clock", fmt::format("{:.0f} ms", 1000 * r.seconds)}};
  return m;
}

}  // namespace

std::vector<ReplayMoment> momentsOf(const std::vector<loops::ClosingRecord>& closings) {
  std::vector<ReplayMoment> moments;
  for (const loops::ClosingRecord& record : closings) {
    const loops::Closing& c = record.closing;
    moments.push_back(detectionOf(record));
    if (c.entered)
      moments.push_back({*c.entered,
                         MomentKind::entry,
                         fmt::format("Loop {}: entry reached", c.id),
                         "From here on the robot is where it has been.",
                         {}});
    if (c.ended) moments.push_back(endOf(record));
    if (record.recovery) moments.push_back(recoveryOf(record));
  }
  return moments;
}

std::string stateInWords(const slam::StepReport& report) {
  const std::string entry =
      report.loops.dist_m && report.loops.dist_g
          ? fmt::format(": entry {:.1f} m away by the map, {:.1f} m by the graph",
                        *report.loops.dist_m, *report.loops.dist_g)
          : "";
  switch (report.loops.state) {
    case loops::LoopState::approaching:
      return "A loop is detected" + entry;
    case loops::LoopState::closing:
      return "Closing a loop, among known places";
    case loops::LoopState::exploring:
      break;
  }
  return "No loop is being closed";
}

}  // namespace ariadne::slam_app
