#include "run_progress.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>

#include "progress.h"

namespace ariadne::experiment_app {

RunProgress::RunProgress(std::ostream& err, bool quiet)
    : err_(err), line_(err, app::progressStyle(quiet, err)) {}

void RunProgress::tell(const batch::ScheduleProgress& p) {
  if (!p.result->failure.empty()) {
    line_.finish();
    fmt::print(err_, "ariadne-experiment: {}: {}\n", p.about, p.result->failure);
  }
  if (!line_.due()) return;
  line_.show(fmt::format("{} of {} runs  {}: {:.1f} s  {} left", p.finished, p.planned, p.about,
                         p.result->wall_s, app::timeText(p.left_s)));
}

}  // namespace ariadne::experiment_app
