// CARMEN logs as records: FLASER, RLASER, ROBOTLASER1 and 2, with the robot's pose on each line.
// http://carmen.sourceforge.net/logger_playback.html
#pragma once
#include "ariadne/io/dataset_records.h"
#include "carmen_line.h"
#include "input_file.h"

namespace ariadne::io {

class CarmenRecords : public RecordSource {
 public:
  /// `path` is read twice: its first scans tell where the laser sits on the robot.
  explicit CarmenRecords(const std::filesystem::path& path);

  std::optional<LogRecord> next() override;
  double fraction() const override { return file_.fraction(); }
  const std::map<std::string, std::size_t>& classes() const override { return classes_; }
  const std::string& damage() const override { return file_.trouble(); }
  std::size_t malformedLines() const override { return malformed_; }
  const char* format() const override { return "CARMEN log"; }
  const std::vector<std::string>& remarks() const override { return remarks_; }

 private:
  std::optional<CarmenScan> nextScan();
  void surveyLasers();

  std::filesystem::path path_;
  InputFile file_;
  std::map<std::string, std::size_t> classes_;
  std::vector<std::string> remarks_;
  std::size_t line_number_ = 0;
  std::size_t malformed_ = 0;
  std::map<std::string, mrpt::math::TPose2D> robot_from_laser_;
  std::vector<std::string_view> words_;
  bool remarked_ = false;
  bool has_robotlaser_ = false;
};

}  // namespace ariadne::io
