// The mapping loop and its progress line.
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "mapping.h"

/// Steps without end; a Ctrl-C at the fourth.
class Endless : public ariadne::io::StepSource {
 public:
  std::optional<ariadne::models::SensorStep> next() override {
    if (++steps_ == 4) std::raise(SIGINT);
    ariadne::models::SensorStep step;
    step.time_s = steps_;
    return step;
  }
  double fraction() const override { return 0.1; }
  const ariadne::io::DatasetCounts& counts() const override { return counts_; }
  std::vector<std::string> warnings() const override { return {}; }
  const std::string& laserLabel() const override { return label_; }

 private:
  int steps_ = 0;
  ariadne::io::DatasetCounts counts_;
  std::string label_;
};

TEST(SlamAppInterrupt, StopsAfterTheStepAndKeepsWhatThereIs) {
  using namespace ariadne;
  const app::Interrupt interrupt;
  slam::Mapper mapper({}, 1);
  std::ostringstream nowhere;
  app::Progress progress(nowhere, app::ProgressStyle::none);
  Endless source;
  const auto record =
      slam_app::mapSteps(source, mapper, {}, interrupt, progress, [](const slam::StepReport&) {});
  EXPECT_EQ(record.signal, SIGINT);
  EXPECT_EQ(record.odometry.size(), 4U);
}

TEST(SlamAppProgress, LineSaysHowFarAndHowLong) {
  using ariadne::slam_app::progressLine;
  EXPECT_EQ(progressLine(0.25, 500, 10, 12.34, 30),
            " 25 %  500 scans  50 scans/s  Neff 12.3 of 30  0:30 left");
  EXPECT_EQ(progressLine(0, 0, 0, 0, 30), "  0 %  0 scans  0 scans/s  Neff 0.0 of 30");
  EXPECT_NE(progressLine(0.5, 9, 7200, 1, 2).find("2:00:00 left"), std::string::npos);
}
