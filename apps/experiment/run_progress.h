// What is told while runs are done: a line rewritten on a terminal, else a line every few seconds;
// failures at once.
#pragma once
#include <iosfwd>
#include <string>

#include "ariadne/batch/schedule.h"
#include "progress.h"

namespace ariadne::experiment_app {

class RunProgress {
 public:
  RunProgress(std::ostream& err, bool quiet);
  void tell(const batch::ScheduleProgress& progress);
  void finish() { line_.finish(); }

 private:
  std::ostream& err_;
  app::Progress line_;
};

}  // namespace ariadne::experiment_app
