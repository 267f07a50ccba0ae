#include "frames.h"

#include <fmt/format.h>
#include <mrpt/math/CQuaternion.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace ariadne::io::ros {
namespace {

using mrpt::poses::CPose3D;

constexpr std::size_t kMostEdges = 100'000;
constexpr double kSame_m = 1e-3;
constexpr double kSame_rad = 0.1 * M_PI / 180;

bool same(const CPose3D& a, const CPose3D& b) {
  const CPose3D change = b - a;
  double trace = 0;
  for (int i = 0; i < 3; ++i) trace += change.getRotationMatrix()(i, i);
  const double turn = std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
  return change.norm() <= kSame_m && turn <= kSame_rad;
}

}  // namespace

CPose3D poseOf(const Pose& pose) {
  return CPose3D(mrpt::math::CQuaternionDouble(pose.qw, pose.qx, pose.qy, pose.qz), pose.x, pose.y,
                 pose.z);
}

const Edge& Frames::add(const Transform& transform, bool is_static) {
  const Key key{transform.header.frame, transform.child_frame};
  const auto found = edges_.find(key);
  if (found == edges_.end() && edges_.size() >= kMostEdges)
    throw BagDamage(fmt::format("over {} different transforms", kMostEdges));
  Edge& edge = found == edges_.end() ? edges_[key] : found->second;
  const CPose3D pose = poseOf(transform.pose);
  edge.is_static = edge.is_static && is_static;
  if (edge.count++ == 0) edge.parent_from_child = pose;
  if (!edge.moves) edge.moves = !same(edge.parent_from_child, pose);
  return edge;
}

std::map<std::string, Frames::Step> Frames::reach(const std::string& target,
                                                  bool moving_too) const {
  std::multimap<std::string, std::pair<std::string, Step>> neighbours;
  for (const auto& [key, edge] : edges_) {
    if (edge.moves && !moving_too) continue;
    neighbours.emplace(key.first, std::pair(key.second, Step{key.first, &edge, true}));
    neighbours.emplace(key.second, std::pair(key.first, Step{key.second, &edge, false}));
  }
  std::map<std::string, Step> steps{{target, Step{}}};
  for (std::deque<std::string> open{target}; !open.empty(); open.pop_front()) {
    const auto [begin, end] = neighbours.equal_range(open.front());
    for (auto it = begin; it != end; ++it)
      if (steps.emplace(it->second.first, it->second.second).second)
        open.push_back(it->second.first);
  }
  return steps;
}

std::set<std::string> Frames::tiedTo(const std::string& frame, bool moving_too) const {
  std::set<std::string> names;
  for (const auto& [name, step] : reach(frame, moving_too)) names.insert(name);
  return names;
}

std::optional<CPose3D> Frames::fixed(const std::string& target, const std::string& source) const {
  const auto steps = reach(target, false);
  CPose3D here_from_source;
  std::string here = source;
  while (here != target) {
    const auto step = steps.find(here);
    if (step == steps.end()) return std::nullopt;
    const CPose3D& pose = step->second.edge->parent_from_child;
    here_from_source = step->second.down ? pose + here_from_source : here_from_source - pose;
    here = step->second.from;
  }
  return here_from_source;
}

std::string Frames::chain(const std::string& target, const std::string& source) const {
  const auto steps = reach(target, true);
  std::string text;
  std::string here = source;
  while (here != target) {
    const auto step = steps.find(here);
    if (step == steps.end()) return "";
    const auto& [from, edge, down] = step->second;
    const auto& [parent, child] = down ? std::pair(from, here) : std::pair(here, from);
    text = fmt::format("{} -> {}{}{}{}", parent, child, edge->moves ? " (moves)" : "",
                       text.empty() ? "" : ", ", text);
    here = from;
  }
  return text;
}

}  // namespace ariadne::io::ros
