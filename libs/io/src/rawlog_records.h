// A rawlog as records: frames and collections are taken apart, what is no 2D laser and no odometry
// is passed over unread.
#pragma once
#include "ariadne/io/dataset_records.h"
#include "rawlog_objects.h"

namespace ariadne::io {

class RawlogRecords : public RecordSource {
 public:
  /// Of a file that looks like an object stream.
  RawlogRecords(std::unique_ptr<InputFile> file, const DatasetOptions& options);

  std::optional<LogRecord> next() override;
  double fraction() const override { return file_->fraction(); }
  const std::map<std::string, std::size_t>& classes() const override { return classes_; }
  const std::string& damage() const override { return damage_; }
  std::size_t malformedLines() const override { return 0; }
  const char* format() const override { return "MRPT rawlog"; }
  const std::vector<std::string>& remarks() const override { return remarks_; }

 private:
  std::optional<LogRecord> nextInFile();
  std::optional<LogRecord> nextInFrame();
  std::optional<LogRecord> readEntry(bool in_frame);
  std::optional<LogRecord> readObservation(const ObjectHeader& object, bool in_frame);
  void passOver(bool in_frame);
  void remarkOn(const NewerVersion& reason);
  void stop(const char* how, const ArchiveDamage& reason);
  void openFrame(const ObjectHeader& frame);
  std::optional<LogRecord> readCollection(const ObjectHeader& collection);

  std::unique_ptr<InputFile> file_;
  ArchiveReader archive_;
  std::map<std::string, std::size_t> classes_;
  std::vector<std::string> remarks_;
  /// Line in `remarks_` and count, by the reason.
  std::map<std::string, std::pair<std::size_t, std::size_t>> newer_;
  std::string damage_;
  bool done_ = false;

  std::size_t entry_ = 0;              ///< of the file's top level
  std::uint64_t object_begin_ = 0;     ///< offset of the object being read
  std::optional<ObjectHeader> frame_;  ///< the frame we are in
  std::uint32_t left_in_frame_ = 0;
  std::optional<double> frame_time_s_;
};

}  // namespace ariadne::io
