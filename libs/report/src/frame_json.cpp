#include "frame_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace ariadne::report {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::int64_t>;

std::int64_t cm(double metres) { return rounded(100 * metres); }

template <class Points>
Numbers flat(const Points& points) {
  Numbers out;
  for (const auto& p : points) {
    out.push_back(cm(p.x));
    out.push_back(cm(p.y));
  }
  return out;
}

Numbers flat(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  Numbers out;
  for (const auto& [a, b] : pairs) {
    out.push_back(a);
    out.push_back(b);
  }
  return out;
}

Json changes(const Numbers& now, const Numbers& before) {
  const auto end =
      before.begin() + static_cast<std::ptrdiff_t>(std::min(now.size(), before.size()));
  const auto differs = std::mismatch(before.begin(), end, now.begin()).second;
  Json out = Json::array({differs - now.begin()});
  for (auto it = differs; it != now.end(); ++it) out.push_back(*it);
  return out;
}

/// x, y, tile of all that changed; tile 0 where there is none any more.
Json changes(const std::vector<PlacedTile>& now, const std::vector<PlacedTile>& before) {
  std::map<std::pair<int, int>, std::uint32_t> changed;
  for (const PlacedTile& t : before) changed[{t.y, t.x}] = 0;
  for (const PlacedTile& t : now) changed[{t.y, t.x}] = t.tile;
  for (const PlacedTile& t : before) {
    const auto found = changed.find({t.y, t.x});
    if (found->second == t.tile) changed.erase(found);
  }
  Json out = Json::array();
  for (const auto& [place, tile] : changed)
    for (const std::int64_t n :
         {std::int64_t{place.second}, std::int64_t{place.first}, std::int64_t{tile}})
      out.push_back(n);
  return out;
}

/// One point a square of 10 cm: frontiers come cell by cell.
Json frontiersOf(const ReplayScene& scene) {
  Json clusters = Json::array();
  for (const auto& cluster : scene.frontiers) {
    std::set<std::pair<std::int64_t, std::int64_t>> squares;
    for (const auto& p : cluster) squares.insert({rounded(10 * p.x), rounded(10 * p.y)});
    Numbers out;
    for (const auto& [x, y] : squares) {
      out.push_back(10 * x);
      out.push_back(10 * y);
    }
    clusters.push_back(out);
  }
  return clusters;
}

}  // namespace

std::int64_t rounded(double value) { return std::isfinite(value) ? std::llround(value) : 0; }

Json cloudJson(const ReplayCloud& cloud) {
  double most = 0;
  for (const ReplayParticle& p : cloud.particles) most = std::max(most, p.weight);
  Numbers out{static_cast<std::int64_t>(cloud.step)};
  // The first as it is, the others as seen from it: short numbers, most of them.
  std::array<std::int64_t, 3> first{};
  for (const ReplayParticle& p : cloud.particles) {
    const auto& pose = p.map_from_robot;
    const std::array<std::int64_t, 3> now{cm(pose.x), cm(pose.y), rounded(1000 * pose.phi)};
    for (std::size_t i = 0; i < 3; ++i) out.push_back(now[i] - first[i]);
    out.push_back(most > 0 ? rounded(100 * p.weight / most) : 0);
    if (out.size() == 5) first = now;
  }
  return out;
}

Json frameJson(const ReplayFrame& frame, const ReplayFrame& before) {
  Json json = {{"step", frame.step},
               {"map", changes(frame.map, before.map)},
               {"path", changes(flat(frame.path), flat(before.path))}};
  json["places"] = changes(flat(frame.graph.places), flat(before.graph.places));
  json["edges"] = changes(flat(frame.graph.edges), flat(before.graph.edges));
  const ReplayScene& scene = frame.scene;
  if (!scene.frontiers.empty()) json["frontiers"] = frontiersOf(scene);
  if (scene.shortcut)
    json["shortcut"] = flat(std::vector{scene.shortcut->entry, scene.shortcut->robot});
  if (!scene.plan.empty()) json["plan"] = flat(scene.plan);
  if (scene.goal) json["goal"] = flat(std::vector{*scene.goal});
  return json;
}

}  // namespace ariadne::report
