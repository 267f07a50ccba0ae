#include "mapping.h"

#include <chrono>

namespace ariadne::slam_app {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

MappingRecord mapSteps(io::StepSource& source, slam::Mapper& mapper, const Interrupt& interrupt,
                       Progress& progress, const UpdateListener& listener) {
  MappingRecord record;
  const Clock::time_point start = Clock::now();
  while ((record.signal = interrupt.signal()) == 0) {
    const Clock::time_point before_reading = Clock::now();
    const auto step = source.next();
    record.reading_s += secondsSince(before_reading);
    if (!step) break;
    record.odometry.push_back({step->time_s, step->odom_from_robot});
    if (const auto report = mapper.process(*step)) {
      record.reports.push_back(*report);
      const Clock::time_point before_listening = Clock::now();
      listener(*report);
      record.recording_s += secondsSince(before_listening);
      progress.update(source.fraction(), record.odometry.size(), report->neff, report->particles);
    }
  }
  progress.finish();
  record.total_s = secondsSince(start);
  return record;
}

}  // namespace ariadne::slam_app
