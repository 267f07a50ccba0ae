// CARMEN logs as records: FLASER, RLASER, ROBOTLASER1 to 5 with the robot's pose on each line, or
// RAWLASER1 to 5 and ODOM. http://carmen.sourceforge.net/logger_playback.html
#pragma once
#include "ariadne/io/dataset_records.h"
#include "carmen_lasers.h"
#include "input_file.h"

namespace ariadne::io {

class CarmenRecords : public RecordSource {
 public:
  /// `path` is read twice: its first scans and PARAMs tell what the lasers are.
  CarmenRecords(const std::filesystem::path& path, const DatasetOptions& options);

  std::optional<LogRecord> next() override;
  double fraction() const override { return file_.fraction(); }
  const std::map<std::string, std::size_t>& classes() const override { return classes_; }
  const std::string& damage() const override { return file_.trouble(); }
  std::size_t malformedLines() const override { return malformed_; }
  const char* format() const override { return "CARMEN log"; }
  const std::vector<std::string>& remarks() const override { return lasers_.remarks(); }
  std::vector<std::string> notes() const override { return lasers_.notes(); }

 private:
  std::optional<LogRecord> recordOf(CarmenLine kind);
  std::optional<LogRecord> takeScan();
  void count(std::string_view kind);
  void countMalformed(const std::string& problem);

  std::filesystem::path path_;
  CarmenLasers lasers_;
  InputFile file_;
  std::map<std::string, std::size_t> classes_;
  std::vector<std::string_view> words_;
  std::size_t line_number_ = 0;
  std::size_t malformed_ = 0;
  bool scans_began_ = false;
};

}  // namespace ariadne::io
