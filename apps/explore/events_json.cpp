#include "events_json.h"

#include "summary.h"

namespace ariadne::explore_app {
namespace {

using Json = nlohmann::ordered_json;

Json pointOf(const mrpt::math::TPoint2D& p) { return {p.x, p.y}; }

Json frontierOf(const explore::Candidate& c) {
  return {{"at_m", pointOf(c.at)},
          {"width_m", c.width_m},
          {"way_m", c.route_m ? Json(*c.route_m) : Json()},
          {"left", c.left.empty() ? Json() : Json(c.left)}};
}

Json loopOf(const explore::LoopNumbers& n) {
  return {{"closing", n.closing},
          {"places", n.places},
          {"dist_m_m", n.dist_m},
          {"dist_g_m", n.dist_g},
          {"te", n.te}};
}

Json eventOf(const explore::Decision& d) {
  Json event = {{"kind", explore::nameOf(d.kind)},
                {"time_s", d.time_s},
                {"update", d.update},
                {"map_from_robot", {d.map_from_robot.x, d.map_from_robot.y, d.map_from_robot.phi}},
                {"text", d.text},
                {"goal_m", d.goal ? pointOf(*d.goal) : Json()},
                {"loop", d.loop ? loopOf(*d.loop) : Json()},
                {"frontiers", Json::array()}};
  for (const explore::Candidate& c : d.frontiers) event["frontiers"].push_back(frontierOf(c));
  return event;
}

}  // namespace

std::string eventsJson(const std::vector<explore::Decision>& decisions) {
  Json json = {{"definitions",
                {{"update", "index of the filter update, a line of steps.csv"},
                 {"map_from_robot", "x m, y m, rad, as s* believed then"},
                 {"loop",
                  "closing: its number in loops.json; places: size of I(s*), Eq. (7); dist_m_m, "
                  "dist_g_m: to the entry by the map and by the graph; te: update of the entry, "
                  "Eq. (9)"},
                 {"frontiers",
                  "all there were, where they were looked for; way_m null: no route there; "
                  "left: why it is not gone to, null: it may be"}}},
               {"events", Json::array()}};
  for (const explore::Decision& d : decisions) json["events"].push_back(eventOf(d));
  return slam_app::jsonText(json);
}

}  // namespace ariadne::explore_app
