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
  } catch (const NewerVersion& reason) {
    stop("cannot be read", reason);
  } catch (const ArchiveDamage& reason) {
    stop("damaged", reason);
  }
  return std::nullopt;
}

void RawlogRecords::stop(const char* how, const ArchiveDamage& reason) {
  done_ = true;
  damage_ = fmt::format("{} at entry {}, byte {} (unpacked): {}", how, entry_, object_begin_,
                        reason.what());
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
  try {
    record = readObservation(object, in_frame);
  } catch (const NewerVersion& reason) {
    remarkOn(reason);
  }
  if (!record) passOver(in_frame);
  if (record && !in_frame) ++entry_;
  return record;
}

/// nullopt: of no interest.
std::optional<LogRecord> RawlogRecords::readObservation(const ObjectHeader& object, bool in_frame) {
  if (object.name == "CObservationOdometry") return readOdometry(archive_, object);
  if (object.name != "CObservation2DRangeScan") return std::nullopt;
  LaserRecord laser = readScan(archive_, object);
  if (in_frame && frame_time_s_) {
    laser.time_s = frame_time_s_;
    laser.scan->timestamp = clockOfSeconds(*frame_time_s_);
  }
  return laser;
}

/// Goes on behind an object that is not read.
void RawlogRecords::passOver(bool in_frame) {
  archive_.skipToNextEntry();
  if (in_frame) {
    // Passing over the frame's last object also passed over the frame's end.
    const std::string next = archive_.nextClass();
    if (left_in_frame_ > 0 && next.rfind("CObservation", 0) == 0) return;
    frame_.reset();
  }
  ++entry_;
}

/// One remark a kind, with a count.
void RawlogRecords::remarkOn(const NewerVersion& reason) {
  constexpr std::size_t kMostKinds = 8;
  const std::string kind = newer_.size() < kMostKinds || newer_.count(reason.what()) > 0
                               ? reason.what()
                               : "other versions that are newer than this program";
  const auto [there, is_new] = newer_.try_emplace(kind, remarks_.size(), 0U);
  auto& [line, count] = there->second;
  if (is_new) remarks_.emplace_back();
  remarks_[line] = fmt::format("{} observations passed over: {}", ++count, kind);
}

void RawlogRecords::openFrame(const ObjectHeader& frame) {
  requireVersion(frame);
  if (frame.version < 2) archive_.bytes(4);  // an ID
  frame_time_s_.reset();
  if (frame.version == 0) frame_time_s_ = secondsOfTicks(archive_.number<std::int64_t>());
  left_in_frame_ = archive_.number<std::uint32_t>();
  frame_ = frame;
}

/// The best movement: by scan matching if there is one (as MRPT does), else the first.
std::optional<LogRecord> RawlogRecords::readCollection(const ObjectHeader& collection) {
  requireVersion(collection);
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
