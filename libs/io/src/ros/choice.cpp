#include "choice.h"

#include <fmt/format.h>

#include "odometry_choice.h"
#include "topic_list.h"

namespace ariadne::io::ros {
namespace {

using mrpt::poses::CPose3D;

constexpr const char* kSayPlace =
    "say where the laser is by [dataset] laser_pose = x y yaw_deg (0 0 0 is the robot's centre), "
    "in m and degrees";

bool isScan(MessageKind kind) { return kind == MessageKind::laser_scan; }

std::map<Survey::LaserKey, Laser> lasersOf(const Survey& survey) {
  std::map<std::string, std::size_t> frames_of_topic;
  for (const auto& [key, scans] : survey.scans) ++frames_of_topic[key.first];
  std::map<Survey::LaserKey, Laser> lasers;
  for (const auto& [key, scans] : survey.scans) {
    const auto& [topic, frame] = key;
    lasers[key] = {frames_of_topic[topic] == 1 ? topic : fmt::format("{}:{}", topic, frame), scans,
                   std::nullopt};
  }
  return lasers;
}

std::string whyNoLaser(const Survey& survey, const std::string& format) {
  for (const auto& [name, info] : survey.topics) {
    if (!isScan(kindOf(info.type))) continue;
    if (info.malformed > 0)
      return fmt::format("no scan on {} can be read: {}", name, info.why_malformed);
    return fmt::format("the scans on {} are serialized as {}; cdr and ros1 are read", name,
                       info.encoding);
  }
  const bool clouds = listOfTopics(survey, [](MessageKind kind) {
                        return kind == MessageKind::point_cloud;
                      }) != "nothing";
  return fmt::format("no sensor_msgs/LaserScan in this {}{}; it holds {}", format,
                     clouds ? " but point clouds: record scans made of them by "
                              "pointcloud_to_laserscan"
                            : "",
                     listOfTopics(survey));
}

/// The laser that is wanted, the first where it cannot be told; `why` says so then.
const Survey::LaserKey* chooseLaser(const Survey& survey, const Choice& choice,
                                    const RosOptions& options, const std::string& format,
                                    std::string& why) {
  if (choice.lasers.empty()) {
    why = whyNoLaser(survey, format);
    return nullptr;
  }
  const std::string wanted = topicName(options.scan_topic);
  std::vector<const Survey::LaserKey*> found;
  std::vector<std::string> all;
  for (const auto& [key, laser] : choice.lasers) {
    all.push_back(
        fmt::format("{} {} ({})", laser.label, survey.topics.at(key.first).type, laser.scans));
    if (wanted.empty() || topicName(laser.label) == wanted || topicName(key.first) == wanted)
      found.push_back(&key);
  }
  if (found.empty())
    why = fmt::format("no laser scans on the topic {}; there is {}: [dataset] scan_topic names one",
                      options.scan_topic, listOf(all));
  if (found.size() > 1)
    why = fmt::format("several lasers: {}; choose one by [dataset] scan_topic", listOf(all));
  return found.empty() ? &choice.lasers.begin()->first : found[0];
}

std::string transformsOf(const Survey& survey) {
  std::vector<std::string> list;
  for (const auto& [key, edge] : survey.frames.edges())
    list.push_back(fmt::format("{} -> {}{}", key.first, key.second, edge.moves ? " (moves)" : ""));
  return listOf(list);
}

/// The frame that the odometry moves. Where its messages name none it is the only one that /tf has
/// below the odometry's frame; else empty.
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
  const std::string way = survey.frames.way(base, frame);
  if (!way.empty())
    return fmt::format("the laser moves on the robot, or its transform is not fixed: {}; {}", way,
                       kSayPlace);
  return fmt::format(
      "where the laser is on the robot is not recorded: no transforms lead from {} to {} (there is "
      "{}; of a recording in parts, tf_static is in the first one); {}, or name the robot's frame "
      "by [dataset] base_frame",
      base, frame, transformsOf(survey), kSayPlace);
}

}  // namespace

Choice choose(const Survey& survey, const RosOptions& options, const std::string& format) {
  Choice choice;
  choice.lasers = lasersOf(survey);
  const auto* laser = chooseLaser(survey, choice, options, format, choice.why_not);
  const std::string frame = laser == nullptr ? "" : laser->second;
  if (laser != nullptr) choice.laser = choice.lasers.at(*laser).label;
  std::string why_no_odometry;
  choice.odometry = chooseOdometry(survey, options, frame, why_no_odometry);
  if (choice.why_not.empty()) choice.why_not = why_no_odometry;
  std::string base = frameName(options.base_frame);
  if (base.empty() && choice.odometry != nullptr) base = baseOf(survey, *choice.odometry);
  for (auto& [key, any] : choice.lasers)
    any.robot_from_laser = placeOf(survey, options, base, key.second);
  if (choice.why_not.empty() && !choice.lasers.at(*laser).robot_from_laser)
    choice.why_not = whyNoPlace(survey, base, frame, choice.odometry->topic);
  return choice;
}

}  // namespace ariadne::io::ros
