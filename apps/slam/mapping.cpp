#include "mapping.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "ariadne/models/scan_odometry.h"
#include "seconds_since.h"

namespace ariadne::slam_app {

using Clock = std::chrono::steady_clock;

MappingRecord mapSteps(io::StepSource& source, slam::Mapper& mapper, const SlamConfig& config,
                       const app::Interrupt& interrupt, app::Progress& progress,
                       const UpdateListener& listener) {
  MappingRecord record;
  checks::DriveWatch watch(config.slam.grid, config.slam.update.least_returns);
  std::optional<models::ScanOdometry> by_scans;
  if (config.dataset.odometry == OdometrySource::scans)
    by_scans.emplace(config.slam.grid, config.slam.matcher, config.slam.filter.proposal_gain);
  const Clock::time_point start = Clock::now();
  while ((record.signal = interrupt.signal()) == 0) {
    const Clock::time_point before_reading = Clock::now();
    auto step = source.next();
    record.reading_s += secondsSince(before_reading);
    if (!step) break;
    if (by_scans) step->odom_from_robot = by_scans->add(*step);
    watch.add(*step);
    record.odometry.push_back({step->time_s, step->odom_from_robot});
    if (const auto report = mapper.process(*step)) {
      record.reports.push_back(*report);
      const Clock::time_point before_listening = Clock::now();
      listener(*report);
      record.recording_s += secondsSince(before_listening);
      if (progress.due())
        progress.show(progressLine(source.fraction(), record.odometry.size(), progress.elapsed_s(),
                                   report->neff, report->particles));
    }
  }
  progress.finish();
  record.drive = watch.figures();
  if (by_scans) record.scans_lost = by_scans->lost();
  record.total_s = secondsSince(start);
  return record;
}

std::string progressLine(double fraction, std::size_t scans, double elapsed_s, double neff,
                         std::size_t particles) {
  const double share = std::clamp(fraction, 0.0, 1.0);
  const double rate = elapsed_s > 0 ? static_cast<double>(scans) / elapsed_s : 0;
  const std::string left = app::timeLeft(share, elapsed_s);
  return fmt::format("{:3.0f} %  {} scans  {:.0f} scans/s  Neff {:.1f} of {}{}{}", 100 * share,
                     scans, rate, neff, particles, left.empty() ? "" : "  ", left);
}

}  // namespace ariadne::slam_app
