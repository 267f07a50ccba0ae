#include "laser_place.h"

#include <fmt/format.h>

#include "topic_list.h"

namespace ariadne::io::ros {
namespace {

using mrpt::poses::CPose3D;

constexpr const char* kSayPlace =
    "say where the laser is by [dataset] laser_pose = x y yaw_deg (0 0 0 is the robot's centre), "
    "in m and degrees";

std::string transformsOf(const Survey& survey) {
  std::vector<std::string> list;
  for (const auto& [key, edge] : survey.frames.edges())
    list.push_back(fmt::format("{} -> {}{}", key.first, key.second, edge.moves ? " (moves)" : ""));
  return listOf(list);
}

}  // namespace

std::string baseOf(const Survey& survey, const OdometrySource& odometry) {
  if (!odometry.child.empty()) return odometry.child;
  std::string base;
  for (const auto& [key, source] : survey.transforms) {
    if (key.first != odometry.parent) continue;
    if (!base.empty()) return "";
    base = key.second;
  }
  return base;
}

std::optional<CPose3D> placeOf(const Survey& survey, const RosOptions& options,
                               const std::string& base, const std::string& frame) {
  constexpr double kDegree = M_PI / 180;
  if (const auto& given = options.laser_pose)
    return CPose3D(given->x_m, given->y_m, 0, given->yaw_deg * kDegree, 0,
                   given->upside_down ? M_PI : 0);
  if (base.empty() || frame.empty()) return std::nullopt;
  return survey.frames.fixed(base, frame);
}

std::string whyNoPlace(const Survey& survey, const std::string& base, const std::string& frame,
                       const std::string& odometry) {
  if (base.empty())
    return fmt::format(
        "the odometry on {} names no child frame: name the robot's frame by "
        "[dataset] base_frame, or {} (transforms: {})",
        odometry, kSayPlace, transformsOf(survey));
  if (frame.empty()) return fmt::format("the scans name no frame: {}", kSayPlace);
  const std::string chain = survey.frames.chain(base, frame);
  if (!chain.empty())
    return fmt::format("the laser moves on the robot, or its transform is not fixed: {}; {}", chain,
                       kSayPlace);
  return fmt::format(
      "where the laser is on the robot is not recorded: no transforms lead from {} to {} (there is "
      "{}; of a recording in parts, tf_static is in the first one); {}, or name the robot's frame "
      "by [dataset] base_frame",
      base, frame, transformsOf(survey), kSayPlace);
}

}  // namespace ariadne::io::ros
