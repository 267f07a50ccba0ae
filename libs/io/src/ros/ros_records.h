// ROS recordings as records: the scans of all lasers, and the odometry that was chosen.
#pragma once
#include <set>

#include "ariadne/io/dataset_records.h"
#include "choice.h"

namespace ariadne::io::ros {

class RosRecords : public RecordSource {
 public:
  /// Looks through the whole recording. Throws core::Error when it cannot be read at all, or when
  /// `goes_on` ends the looking through.
  RosRecords(const std::filesystem::path& path, const RosOptions& options,
             const std::function<bool(double)>& goes_on);

  std::optional<LogRecord> next() override;
  double fraction() const override { return files_->fraction(); }
  /// Topics with their types.
  const std::map<std::string, std::size_t>& classes() const override { return classes_; }
  const std::string& damage() const override { return survey_.damage; }
  std::size_t malformedLines() const override { return malformed_; }
  const char* format() const override { return files_->format(); }
  const std::vector<std::string>& remarks() const override { return remarks_; }
  std::vector<std::string> notes() const override { return choice_.notes; }
  std::string chosenLaser() const override { return choice_.laser; }
  std::string whyNot() const override { return choice_.why_not; }

 private:
  struct Scan {
    double key = 0;
    LaserRecord record;
  };
  std::optional<Scan> nextScan();
  std::optional<Scan> readScan(const BagMessage& message);
  LogRecord takeOdometry();
  void tellMalformed(const std::string& topic, const std::string& why);

  std::unique_ptr<BagFiles> files_;
  Survey survey_;
  Choice choice_;
  std::map<std::string, std::size_t> classes_;
  std::vector<std::string> remarks_;
  std::map<std::string, RecordClock> clocks_;
  std::set<std::string> told_;  ///< what is told once a topic
  std::optional<Scan> scan_;    ///< read, and not given out while odometry before it is left
  std::size_t odometry_given_ = 0;
  std::size_t malformed_ = 0;
};

}  // namespace ariadne::io::ros
