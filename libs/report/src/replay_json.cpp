#include "replay_json.h"

#include <nlohmann/json.hpp>

#include "frame_json.h"
#include "steps_json.h"
#include "tile_atlas.h"

namespace ariadne::report {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(MomentKind kind) {
  switch (kind) {
    case MomentKind::detection:
      return "detection";
    case MomentKind::entry:
      return "entry";
    case MomentKind::end:
      return "end";
    case MomentKind::recovery:
      return "recovery";
    case MomentKind::decision:
      break;
  }
  return "decision";
}

Json momentsJson(const Replay& r) {
  Json out = Json::array();
  for (const ReplayMoment& m : r.moments)
    out.push_back({{"step", m.step},
                   {"kind", nameOf(m.kind)},
                   {"title", m.title},
                   {"text", m.text},
                   {"table", m.table}});
  return out;
}

Json headJson(const Replay& r) {
  Json facts = Json::array();
  for (const ReplayFact& f : r.facts) facts.push_back(Json::array({f.name, f.value}));
  return {{"title", r.title},
          {"facts", facts},
          {"notes", r.notes},
          {"particles", r.particles},
          {"steps", stepsJson(r)},
          {"moments", momentsJson(r)},
          {"map",
           {{"pixel_m", r.pixel_m},
            {"x_m", r.map_origin.x},
            {"y_m", r.map_origin.y},
            {"tile", kReplayTile},
            {"tiles", r.tiles.size()},
            {"per_picture", kTilesPerPicture},
            {"pictures", tilePictures(r.tiles)}}}};
}

/// As text that an HTML parser cannot take for markup.
std::string textOf(const Json& json) {
  const std::string plain = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(plain.size());
  for (const char c : plain) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string replayJson(const Replay& replay) {
  std::string out = textOf(headJson(replay));
  out.back() = ',';  // for the closing brace
  out += "\"clouds\":[";
  for (const ReplayCloud& c : replay.clouds) out += textOf(cloudJson(c)) + ',';
  if (out.back() == ',') out.pop_back();
  out += "],\"frames\":[";
  // One by one: all at once would take memory many times the text's.
  const ReplayFrame nothing;
  for (std::size_t i = 0; i < replay.frames.size(); ++i) {
    if (i > 0) out += ',';
    out += textOf(frameJson(replay.frames[i], i > 0 ? replay.frames[i - 1] : nothing));
  }
  return out + "]}";
}

}  // namespace ariadne::report
