#include "decision_moments.h"

#include <fmt/format.h>

#include <cctype>

namespace ariadne::explore_app {
namespace {

using explore::DecisionKind;

const char* titleOf(DecisionKind kind) {
  switch (kind) {
    case DecisionKind::frontier:
      return "To a frontier";
    case DecisionKind::approach:
      return "To the entry of a loop";
    case DecisionKind::follow:
      return "Through the loop";
    case DecisionKind::give_up:
      return "Leaves the loop";
    case DecisionKind::touched:
      return "Touched something";
    case DecisionKind::home:
      return "Home";
    case DecisionKind::end:
      break;
  }
  return "The end";
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

std::vector<std::vector<std::string>> frontierTable(const std::vector<explore::Candidate>& all) {
  if (all.empty()) return {};
  std::vector<std::vector<std::string>> rows{{"frontier at, m", "width, m", "route, m", "left"}};
  for (const explore::Candidate& c : all)
    rows.push_back({fmt::format("{:.1f}, {:.1f}", c.at.x, c.at.y), fmt::format("{:.1f}", c.width_m),
                    c.route_m ? fmt::format("{:.1f}", *c.route_m) : "none", c.left});
  return rows;
}

}  // namespace

report::ReplayMoment momentOf(const explore::Decision& d) {
  report::ReplayMoment moment;
  moment.step = d.update;
  moment.kind = report::MomentKind::decision;
  moment.title = titleOf(d.kind);
  moment.text = sentence(d.text);
  moment.table = frontierTable(d.frontiers);
  if (d.loop)
    moment.table = {{"what", "value"},
                    {"loop", fmt::format("{}", d.loop->closing)},
                    {"places in I(s*), Eq. (7)", fmt::format("{}", d.loop->places)},
                    {"dist_m to the entry", fmt::format("{:.2f} m", d.loop->dist_m)},
                    {"dist_G to the entry", fmt::format("{:.2f} m", d.loop->dist_g)},
                    {"te, Eq. (9)", fmt::format("update {}", d.loop->te)}};
  return moment;
}

report::ReplayScene sceneOf(const explore::Explorer& explorer, const slam::Mapper& mapper) {
  report::ReplayScene scene;
  for (const explore::Frontier& f : explorer.frontiers())
    if (f.left.empty()) scene.frontiers.push_back(f.cells);
  scene.plan = explorer.route();
  if (!scene.plan.empty()) scene.goal = scene.plan.back();
  const auto open = mapper.openClosings();
  if (!open.empty() && !open.back()->entered) {
    const auto pose = mapper.pose();
    scene.shortcut = report::ReplayShortcut{open.back()->entry_position, {pose.x, pose.y}};
  }
  return scene;
}

}  // namespace ariadne::explore_app
