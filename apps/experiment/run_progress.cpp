#include "run_progress.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>
#include <ostream>

#include "run_program.h"

namespace ariadne::experiment_app {

RunProgress::RunProgress(std::ostream& err, bool quiet)
    : err_(err), line_(err, slam_app::progressStyle(quiet, err)) {}

void RunProgress::tell(const batch::ScheduleProgress& p) {
  if (!p.result->failure.empty()) {
    line_.finish();
    fmt::print(err_, "ariadne-experiment: {}: {}\n", p.about, p.result->failure);
  }
  if (!line_.due()) return;
  line_.show(fmt::format("{} of {} runs  {}: {:.1f} s  {} left", p.finished, p.planned, p.about,
                         p.result->wall_s, timeText(p.left_s)));
}

std::string timeText(double seconds) {
  const auto s = std::lround(std::max(0.0, std::min(seconds, 1e10)));
  if (s >= 3600) return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
  return fmt::format("{}:{:02}", s / 60, s % 60);
}

}  // namespace ariadne::experiment_app
