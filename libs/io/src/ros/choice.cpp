#include "choice.h"

#include <fmt/format.h>

#include "laser_place.h"
#include "odometry_choice.h"
#include "topic_list.h"

namespace ariadne::io::ros {
namespace {

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

void noteChoice(const Survey& survey, const RosOptions& options, const std::string& base,
                const std::string& frame, Choice& choice) {
  const OdometrySource& odometry = *choice.odometry;
  choice.notes.push_back(fmt::format("odometry: {}, {} -> {}", odometry.topic, odometry.parent,
                                     base.empty() ? "the robot" : base));
  const std::string chain =
      options.laser_pose ? "as laser_pose says" : survey.frames.chain(base, frame);
  choice.notes.push_back(fmt::format("the laser on the robot: {}",
                                     chain.empty() ? fmt::format("in its frame {}", base) : chain));
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
  if (choice.why_not.empty()) noteChoice(survey, options, base, frame, choice);
  return choice;
}

}  // namespace ariadne::io::ros
