#include "rawlog_records.h"

#include <fmt/format.h>

namespace ariadne::io {
namespace {

bool isMovement(const std::string& name) { return name.rfind("CActionRobotMovement", 0) == 0; }

}  // namespace

RawlogRecords::RawlogRecords(std::unique_ptr<InputFile> file, const DatasetOptions& options)
    : file_(std::move(file)), archive_(*file_) {
  if (options.field_of_view_deg > 0)
    remarks_.push_back("field_of_view_deg is not used: a rawlog's scans carry their angles");
}

std::optional<LogRecord> RawlogRecords::next() {
  try {
    while (!done_) {
      if (auto record = frame_ ? nextInFrame() : nextInFile()) return record;
    }
  } catch (const ArchiveDamage& reason) {
    done_ = true;
    damage_ = fmt::format("damaged at entry {}, byte {} (unpacked): {}", entry_, object_begin_,
                          reason.what());
  }
  return std::nullopt;
}

std::optional<LogRecord> RawlogRecords::nextInFile() {
  object_begin_ = file_->offset();
  if (archive_.atEnd()) {
    done_ = true;
    if (!file_->trouble().empty()) throw ArchiveDamage(file_->trouble());
    return std::nullopt;
  }
  return readEntry(false);
}

std::optional<LogRecord> RawlogRecords::nextInFrame() {
  object_begin_ = file_->offset();
  if (left_in_frame_ == 0) {
    archive_.end(*frame_);
    frame_.reset();
    ++entry_;
    return std::nullopt;
  }
  --left_in_frame_;
  return readEntry(true);
}

std::optional<LogRecord> RawlogRecords::readEntry(bool in_frame) {
  const ObjectHeader object = archive_.header();
  ++classes_[object.name];
  if (object.name == "CSensoryFrame") {
    if (in_frame) throw ArchiveDamage("a frame within a frame");
    openFrame(object);
    return std::nullopt;
  }
  if (object.name == "CActionCollection") {
    if (in_frame) throw ArchiveDamage("a collection of actions within a frame");
    auto increment = readCollection(object);
    ++entry_;
    return increment;
  }
  std::optional<LogRecord> record;
  if (object.name == "CObservation2DRangeScan") {
    LaserRecord laser = readScan(archive_, object);
    if (in_frame && frame_time_s_) {
      laser.time_s = frame_time_s_;
      laser.scan->timestamp = clockOfSeconds(*frame_time_s_);
    }
    record = std::move(laser);
  } else if (object.name == "CObservationOdometry") {
    record = readOdometry(archive_, object);
  } else {
    archive_.skipToNextEntry();
    if (!in_frame) {
      ++entry_;
      return std::nullopt;
    }
    // Passing over the frame's last object also passed over the frame's end.
    const std::string next = archive_.nextClass();
    if (left_in_frame_ == 0 || next.empty() || next.rfind("CObservation", 0) != 0) {
      frame_.reset();
      ++entry_;
    }
    return std::nullopt;
  }
  if (!in_frame) ++entry_;
  return record;
}

void RawlogRecords::openFrame(const ObjectHeader& frame) {
  requireVersion(frame, 2);
  if (frame.version < 2) archive_.bytes(4);  // an ID
  frame_time_s_.reset();
  if (frame.version == 0) frame_time_s_ = secondsOfTicks(archive_.number<std::int64_t>());
  left_in_frame_ = archive_.number<std::uint32_t>();
  frame_ = frame;
}

/// The best movement: by scan matching if there is one (as MRPT does), else the first.
std::optional<LogRecord> RawlogRecords::readCollection(const ObjectHeader& collection) {
  requireVersion(collection, 0);
  std::optional<Movement> best;
  bool end_passed = false;
  for (auto left = archive_.number<std::uint32_t>(); left > 0 && !end_passed; --left) {
    object_begin_ = file_->offset();
    const ObjectHeader action = archive_.header();
    ++classes_[action.name];
    if (action.name == "CActionRobotMovement2D") {
      const Movement movement = readMovement(archive_, action);
      if (!best || (movement.from_matching && !best->from_matching)) best = movement;
    } else {
      archive_.skipToNextEntry();
      end_passed = left == 1 || !isMovement(archive_.nextClass());
    }
  }
  if (!end_passed) archive_.end(collection);
  if (!best) return std::nullopt;
  return best->increment;
}

}  // namespace ariadne::io
