#include "odometry_choice.h"

#include <fmt/format.h>

#include "topic_list.h"

namespace ariadne::io::ros {
namespace {

bool isOdometry(MessageKind kind) {
  return kind == MessageKind::odometry || kind == MessageKind::transforms;
}

std::string listOfSources(const std::vector<const OdometrySource*>& sources) {
  std::vector<std::string> list;
  for (const OdometrySource* s : sources)
    list.push_back(fmt::format("{} -> {}", s->parent, s->child));
  return listOf(list);
}

using Sources = std::vector<const OdometrySource*>;

/// What of the transforms on /tf can be odometry.
Sources candidates(const Survey& survey, const RosOptions& options,
                   const std::string& laser_frame) {
  const std::string topic = topicName(options.odom_topic);
  const std::string odom = frameName(options.odom_frame), base = frameName(options.base_frame);
  const auto fixed = survey.frames.tiedTo(laser_frame, false);
  const auto tied = survey.frames.tiedTo(laser_frame, true);
  Sources named, named_above, moving;
  for (const auto& [key, source] : survey.transforms) {
    if (!topic.empty() && topicName(source.topic) != topic) continue;
    if (!odom.empty() && key.first != odom) continue;
    if (!base.empty() && key.second != base) continue;
    if (!odom.empty() || isOdometryFrame(key.first)) {
      named.push_back(&source);
      if (tied.count(key.second) > 0) named_above.push_back(&source);
    }
    if (survey.frames.edges().at(key).moves && (!base.empty() || fixed.count(key.second) > 0))
      moving.push_back(&source);
  }
  if (named.empty()) return moving;
  return named.size() > 1 && !named_above.empty() ? named_above : named;
}

const OdometrySource* chooseTransform(const Survey& survey, const RosOptions& options,
                                      const std::string& laser_frame, std::string& why) {
  const Sources found = candidates(survey, options, laser_frame);
  if (found.size() == 1) return found[0];
  if (found.size() > 1) {
    why = fmt::format(
        "several transforms could be the odometry: {}; choose by [dataset] odom_frame "
        "and base_frame",
        listOfSources(found));
    return nullptr;
  }
  for (const auto& [name, topic] : survey.topics)
    if (kindOf(topic.type) == MessageKind::odometry && options.odom_topic.empty()) {
      why = fmt::format(
          "no odometry: of {} messages on {} none can be read: {}", topic.messages, name,
          topic.malformed > 0 ? topic.why_malformed
                              : fmt::format("they are serialized as {}", topic.encoding));
      return nullptr;
    }
  Sources all;
  for (const auto& [key, source] : survey.transforms) all.push_back(&source);
  const bool asked = !options.odom_frame.empty() || !options.base_frame.empty();
  why = fmt::format(
      "no odometry: {} (transforms on /tf: {}; topics: {})",
      asked ? "no transform on /tf is as [dataset] odom_frame and base_frame say"
            : "there is no nav_msgs/Odometry, and no transform on /tf from a frame called odom; if "
              "that frame has another name, [dataset] odom_frame says it",
      listOfSources(all), listOfTopics(survey));
  return nullptr;
}

}  // namespace

const OdometrySource* chooseOdometry(const Survey& survey, const RosOptions& options,
                                     const std::string& laser_frame, std::string& why) {
  const std::string wanted = topicName(options.odom_topic);
  if (!wanted.empty()) {
    for (const auto& [topic, source] : survey.odometry)
      if (topicName(topic) == wanted) return &source;
    for (const auto& [topic, info] : survey.topics)
      if (topicName(topic) == wanted && kindOf(info.type) == MessageKind::transforms)
        return chooseTransform(survey, options, laser_frame, why);
    why = fmt::format("no odometry on the topic {}; there is {}", options.odom_topic,
                      listOfTopics(survey, isOdometry));
    return nullptr;
  }
  if (survey.odometry.size() == 1 && options.odom_frame.empty())
    return &survey.odometry.begin()->second;
  if (survey.odometry.empty() || !options.odom_frame.empty())
    return chooseTransform(survey, options, laser_frame, why);
  why = fmt::format("several topics with odometry: {}; choose one by [dataset] odom_topic",
                    listOfTopics(survey, isOdometry));
  return nullptr;
}

}  // namespace ariadne::io::ros
