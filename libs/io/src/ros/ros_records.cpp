#include "ros_records.h"

#include <fmt/format.h>

#include "../rawlog_objects.h"
#include "ariadne/core/error.h"
#include "scan_record.h"

namespace ariadne::io::ros {
namespace {

Survey lookThrough(const std::filesystem::path& path, const std::function<bool(double)>& goes_on) {
  BagFiles files(path);
  bool stopped = false;
  Survey survey = surveyOf(files, [&](double share) {
    stopped = goes_on && !goes_on(share);
    return !stopped;
  });
  if (stopped) throw core::Error(fmt::format("{}: stopped before the first scan", path.string()));
  return survey;
}

}  // namespace

RosRecords::RosRecords(const std::filesystem::path& path, const RosOptions& options,
                       const std::function<bool(double)>& goes_on)
    : files_(std::make_unique<BagFiles>(path)), survey_(lookThrough(path, goes_on)) {
  choice_ = choose(survey_, options, files_->format());
  remarks_ = survey_.remarks;
  for (const auto& [name, topic] : survey_.topics) {
    classes_[fmt::format("{} ({})", name, topic.type)] = topic.messages;
    if (topic.malformed == 0 || kindOf(topic.type) == MessageKind::laser_scan) continue;
    malformed_ += topic.malformed;
    tellMalformed(name, topic.why_malformed);
  }
}

void RosRecords::tellMalformed(const std::string& topic, const std::string& why) {
  remarks_.push_back(fmt::format("{}: {} (first message that cannot be read)", topic, why));
}

std::optional<RosRecords::Scan> RosRecords::readScan(const BagMessage& message) {
  const auto payload = files_->payload();
  if (!payload) return std::nullopt;
  const LaserScan read = readLaserScan(*message.topic, *payload);
  const auto laser = choice_.lasers.find({message.topic->name, read.header.frame});
  if (laser == choice_.lasers.end()) return std::nullopt;
  const auto& place = laser->second.robot_from_laser;
  Scan scan;
  scan.key = clocks_[message.topic->name].key(message.time_ns);
  scan.record = recordOf(read, laser->second.label, place.value_or(mrpt::poses::CPose3D()));
  scan.record.place_known = place.has_value();
  if (scan.record.scan->maxRange != read.range_max && told_.insert(laser->second.label).second)
    remarks_.push_back(fmt::format("{}: range_max is {:g}; {:g} m is taken", laser->second.label,
                                   read.range_max, scan.record.scan->maxRange));
  const double time_s = secondsOf(read.header, message.time_ns);
  scan.record.time_s = time_s;
  scan.record.scan->timestamp = clockOfSeconds(time_s);
  return scan;
}

std::optional<RosRecords::Scan> RosRecords::nextScan() {
  while (const auto message = files_->next()) {
    if (kindOf(message->topic->type) != MessageKind::laser_scan || !isReadable(*message->topic))
      continue;
    try {
      if (auto scan = readScan(*message)) return scan;
    } catch (const BagDamage& why) {
      ++malformed_;
      if (told_.insert("unreadable " + message->topic->name).second)
        tellMalformed(message->topic->name, why.what());
    }
  }
  return std::nullopt;
}

LogRecord RosRecords::takeOdometry() {
  const OdometryPose& pose = choice_.odometry->poses[odometry_given_++];
  return OdometryReading{pose.time_s, pose.odom_from_robot, choice_.odometry->topic};
}

std::optional<LogRecord> RosRecords::next() {
  if (!scan_) scan_ = nextScan();
  const bool odometry_left =
      choice_.odometry != nullptr && odometry_given_ < choice_.odometry->poses.size();
  if (odometry_left && (!scan_ || choice_.odometry->poses[odometry_given_].key <= scan_->key))
    return takeOdometry();
  if (!scan_) return std::nullopt;
  LogRecord record = std::move(scan_->record);
  scan_.reset();
  return record;
}

}  // namespace ariadne::io::ros
