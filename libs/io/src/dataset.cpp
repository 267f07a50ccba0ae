#include "ariadne/io/dataset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset_records.h"
#include "carmen_records.h"
#include "dataset_warnings.h"
#include "odometry_track.h"
#include "raw_step.h"
#include "rawlog_records.h"
#include "ready_steps.h"
#include "ros/open_bag.h"
#include "ros/ros_records.h"
#include "scan_check.h"

namespace ariadne::io {
namespace {

constexpr std::size_t kMostWithoutOdometry = 1000;
constexpr std::size_t kMostWithoutAngles = 1000;
constexpr const char* kNoLabel = "(none)";

class Steps : public StepSource {
 public:
  Steps(const std::filesystem::path& path, const DatasetOptions& options)
      : path_(path),
        records_(openRecords(path, options)),
        wanted_(options.laser_label),
        track_(counts_, options.use_odometry),
        ready_(options, counts_) {
    if (wanted_ && wanted_->empty()) wanted_.reset();
    if (const std::string why = records_->whyNot(); !why.empty()) throw failure(why + details());
    if (const std::string chosen = records_->chosenLaser(); !chosen.empty()) wanted_ = chosen;
    const bool any = !wanted_;
    if (wanted_ == kNoLabel) wanted_ = "";
    while (ready_.wantsMore() && readRecord() && !isHopeless()) continue;
    if (any && labels_.size() > 1)
      throw failure(fmt::format(
          "several lasers: {}; choose one by its label: [dataset] laser_label, as in --set "
          "dataset.laser_label=\"{}\", or ariadne-dataset's --laser",
          listLabels(), named(labels_.begin()->first)));
    if (ready_.empty()) throw failure(whyNothing());
    refuseWhenMostAreLost(ready_.size());
  }

  std::optional<models::SensorStep> next() override {
    while (ready_.wantsMore() && readRecord()) {
    }
    auto step = ready_.pop();
    if (!step) refuseWhenMostAreLost(counts_.steps);
    return step;
  }
  double fraction() const override {
    return ended_ && ready_.empty() ? records_->fraction() : ready_.fraction();
  }
  const DatasetCounts& counts() const override { return counts_; }
  const std::string& laserLabel() const override { return *wanted_; }
  std::vector<std::string> warnings() const override { return datasetWarnings(counts_, *records_); }

 private:
  core::Error failure(const std::string& why) const {
    return core::Error(fmt::format("{}: {}", path_.string(), why));
  }

  /// Nothing to use in so many scans: what follows will not be better.
  bool isHopeless() const {
    if (!track_.hasOdometry() && track_.waiting() > kMostWithoutOdometry) return true;
    return ready_.empty() && !problem_.empty() && counts_.scans_malformed > kMostWithoutAngles;
  }

  /// Takes one record in; false when there is none left.
  bool readRecord() {
    if (ended_) return false;
    auto record = records_->next();
    if (record) {
      std::visit([this](auto& r) { take(r); }, *record);
    } else {
      ended_ = true;
      gate_.finish();
    }
    while (auto passed = gate_.pop())
      track_.add(std::move(passed->second.step), passed->second.place);
    if (ended_) track_.finish();
    while (auto step = track_.pop()) ready_.push(std::move(*step), records_->fraction());
    counts_.scans_backwards = gate_.rejected();
    counts_.scan_clock = gate_.setBacks();
    counts_.lines_malformed = records_->malformedLines();
    return record.has_value();
  }

  void take(const OdometryIncrement& increment) { track_.add(increment); }
  void take(const OdometryReading& reading) { track_.add(reading); }
  void take(LaserRecord& laser) {
    auto& scan = *laser.scan;
    ++labels_[scan.sensorLabel];
    if (!wanted_) wanted_ = scan.sensorLabel;
    if (scan.sensorLabel != *wanted_) {
      ++counts_.scans_other_lasers;
    } else if (!repairGeometry(laser)) {
      if (!laser.problem.empty()) problem_ = laser.problem;
      ++counts_.scans_malformed;
    } else if (!isPlanar(scan)) {
      ++counts_.scans_not_planar;
    } else {
      RawStep step;
      if (!track_.poseOfScan(laser.odom_from_robot, step.odom_from_robot)) return;
      last_time_s_ = step.time_s = laser.time_s.value_or(last_time_s_);
      if (!laser.time_s) {
        ++counts_.scans_without_stamp;
        scan.timestamp = clockOfSeconds(step.time_s);
      }
      step.scan = laser.scan;
      step.beams = std::move(laser.beams);
      gate_.push(last_time_s_, {std::move(step), track_.readings()});
    }
  }

  void refuseWhenMostAreLost(std::size_t used) const {
    if (counts_.scans_backwards <= used) return;
    throw failure(fmt::format(
        "{} of {} scans have stamps that neither go on nor start over: put the scans in order of "
        "time, or give them stamps that grow",
        counts_.scans_backwards, counts_.scans_backwards + used));
  }

  static std::string named(const std::string& label) { return label.empty() ? kNoLabel : label; }

  std::string listLabels() const {
    std::vector<std::string> list;
    for (const auto& [label, count] : labels_)
      list.push_back(fmt::format("{} ({} scans)", named(label), count));
    return fmt::format("{}", fmt::join(list, ", "));
  }

  std::string details() const {
    const auto notes = datasetWarnings(counts_, *records_);
    return notes.empty() ? "" : fmt::format(" [{}]", fmt::join(notes, "; "));
  }

  std::string whyNothing() const {
    std::vector<std::string> found;
    for (const auto& [name, count] : records_->classes())
      if (found.size() < 12) found.push_back(fmt::format("{} {}", count, name));
    const std::string contents =
        found.empty() ? "nothing" : fmt::format("{}", fmt::join(found, ", "));
    if (labels_.empty())
      return fmt::format("no 2D laser scan in this {} (found: {}){}", records_->format(), contents,
                         details());
    if (labels_.count(*wanted_) == 0)
      return fmt::format("no laser is called '{}'; there is {}", *wanted_, listLabels());
    if (!track_.hasOdometry() && track_.waiting() > 0)
      return fmt::format("no odometry in this {} (found: {}){}", records_->format(), contents,
                         details());
    if (!problem_.empty()) return problem_;
    return fmt::format("no usable scan in this {}{}", records_->format(), details());
  }

  std::filesystem::path path_;
  std::unique_ptr<RecordSource> records_;
  std::optional<std::string> wanted_;
  DatasetCounts counts_;
  OdometryTrack track_;
  struct Placed {
    RawStep step;
    std::size_t place;  // among the odometry readings
  };
  TimeGate<Placed> gate_;
  std::map<std::string, std::size_t> labels_;
  ReadySteps ready_;
  std::string problem_;  ///< of the last scan that had none of the angles it needs
  double last_time_s_ = 0;
  bool ended_ = false;
};

bool looksLikeText(std::string_view beginning) {
  for (const char c : beginning) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 32 && u != '\n' && u != '\r' && u != '\t') return false;
  }
  return true;
}

/// A recording of ROS knows its lasers by their topics.
RosOptions rosOptionsOf(const DatasetOptions& options) {
  RosOptions ros = options.ros;
  if (ros.scan_topic.empty()) ros.scan_topic = options.laser_label;
  return ros;
}

}  // namespace

std::unique_ptr<RecordSource> openRecords(const std::filesystem::path& path,
                                          const DatasetOptions& options) {
  if (ros::looksLikeBag(path))
    return std::make_unique<ros::RosRecords>(path, rosOptionsOf(options), options.goes_on);
  auto file = std::make_unique<InputFile>(path);
  const std::string_view beginning = file->peek(2048);
  const auto failure = [&](const std::string& why) {
    return core::Error(fmt::format("{}: {}", path.string(), why));
  };
  if (beginning.empty())
    throw failure(file->trouble().empty() ? "the file is empty" : file->trouble());
  if (options.ros.any())
    throw failure(
        "no recording of ROS: scan_topic, odom_topic, odom_frame, base_frame and "
        "laser_pose mean nothing here");
  if (ros::formatOf(beginning) != ros::BagFormat::none)
    throw failure("a recording of ROS inside gzip: unpack it with gunzip first");
  if (looksLikeArchive(beginning)) return std::make_unique<RawlogRecords>(std::move(file), options);
  if (!looksLikeText(beginning.substr(0, 2048)))
    throw failure("neither an MRPT rawlog nor a CARMEN log nor a recording of ROS");
  return std::make_unique<CarmenRecords>(path, options);
}

std::unique_ptr<StepSource> openDataset(const std::filesystem::path& path,
                                        const DatasetOptions& options) {
  return std::make_unique<Steps>(path, options);
}

}  // namespace ariadne::io
