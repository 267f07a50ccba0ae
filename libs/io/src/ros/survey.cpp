#include "survey.h"

#include <fmt/format.h>

#include <algorithm>

namespace ariadne::io::ros {
namespace {

constexpr std::size_t kMostPoses = 20'000'000;
constexpr std::size_t kMessagesPerCall = 256;

std::string lastPart(const std::string& name) { return name.substr(name.rfind('/') + 1); }

/// The plane's part of a pose. The heading is that of the robot's x axis on the floor.
mrpt::math::TPose2D onFloor(const Pose& p) {
  return {p.x, p.y,
          std::atan2(2 * (p.qw * p.qz + p.qx * p.qy), 1 - 2 * (p.qy * p.qy + p.qz * p.qz))};
}

class Surveyor {
 public:
  void take(const BagMessage& message, BagFiles& files) {
    const BagTopic& topic = *message.topic;
    TopicInfo& info = survey_.topics[topic.name];
    if (info.messages++ == 0) {
      info.type = topic.type;
      info.encoding = topic.encoding;
    }
    const MessageKind kind = kindOf(topic.type);
    if (kind == MessageKind::other || kind == MessageKind::point_cloud || !isReadable(topic))
      return;
    const auto payload = files.payload();
    if (!payload) return;
    try {
      if (kind == MessageKind::laser_scan)
        ++survey_.scans[{topic.name, readHeader(topic, *payload).frame}];
      if (kind == MessageKind::odometry) takeOdometry(message, *payload);
      if (kind == MessageKind::transforms) takeTransforms(message, *payload);
    } catch (const BagDamage& why) {
      if (info.malformed++ == 0) info.why_malformed = why.what();
    }
  }
  Survey finish() {
    if (lost_ > 0)
      survey_.remarks.push_back(fmt::format(
          "{} poses of the odometry are lost: over {} are not kept", lost_, kMostPoses));
    return std::move(survey_);
  }

 private:
  void takeOdometry(const BagMessage& message, std::string_view payload) {
    const Odometry odometry = readOdometry(*message.topic, payload);
    OdometrySource& source = survey_.odometry[message.topic->name];
    source.topic = message.topic->name;
    if (source.parent.empty()) source.parent = odometry.header.frame;
    if (source.child.empty()) source.child = odometry.child_frame;
    keep(source, message, odometry.header, odometry.pose);
  }

  void takeTransforms(const BagMessage& message, std::string_view payload) {
    const bool is_static = lastPart(message.topic->name) == "tf_static";
    for (const Transform& t : readTransforms(*message.topic, payload)) {
      const Edge& edge = survey_.frames.add(t, is_static);
      if (is_static) continue;
      OdometrySource& source = survey_.transforms[{t.header.frame, t.child_frame}];
      source.topic = message.topic->name;
      source.parent = t.header.frame;
      source.child = t.child_frame;
      // Of what does not move the first and the last are enough.
      if (!edge.moves && !isOdometryFrame(source.parent) && source.poses.size() > 1) {
        source.poses.pop_back();
        --poses_;
      }
      keep(source, message, t.header, t.pose);
    }
  }

  void keep(OdometrySource& source, const BagMessage& message, const Header& header,
            const Pose& pose) {
    if (poses_ >= kMostPoses) {
      ++lost_;
      return;
    }
    ++poses_;
    source.poses.push_back({clocks_[message.topic->name].key(message.time_ns),
                            secondsOf(header, message.time_ns), onFloor(pose)});
  }

  Survey survey_;
  std::map<std::string, RecordClock> clocks_;
  std::size_t poses_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace

double RecordClock::key(std::int64_t time_ns) {
  const double time_s = static_cast<double>(time_ns) * 1e-9;
  if (time_s + shift_ < last_) shift_ = last_ - time_s;
  return last_ = std::max(last_, time_s + shift_);
}

double secondsOf(const Header& header, std::int64_t recorded_ns) {
  // To the same bits as a rawlog's stamp of the same time (secondsOfTicks).
  return static_cast<double>(static_cast<long double>(header.stamp_ns.value_or(recorded_ns)) /
                             1e9L);
}

bool isReadable(const BagTopic& topic) {
  return topic.encoding == "ros1" || topic.encoding == "cdr";
}

bool isOdometryFrame(const std::string& frame) { return lastPart(frame).rfind("odom", 0) == 0; }

Survey surveyOf(BagFiles& files, const std::function<bool(double)>& goes_on) {
  Surveyor surveyor;
  std::size_t messages = 0;
  while (const auto message = files.next()) {
    surveyor.take(*message, files);
    if (++messages % kMessagesPerCall == 0 && goes_on && !goes_on(files.fraction())) break;
  }
  Survey survey = surveyor.finish();
  const auto& remarks = files.remarks();
  survey.remarks.insert(survey.remarks.end(), remarks.begin(), remarks.end());
  survey.damage = files.damage();
  return survey;
}

}  // namespace ariadne::io::ros
