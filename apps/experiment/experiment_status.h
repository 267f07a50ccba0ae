// How far an experiment is, and what failed.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::experiment_app {

struct Counts {
  std::size_t planned = 0;  ///< different runs
  std::size_t finished = 0;
  std::size_t failed = 0;
};

Counts countRuns(const batch::Plan& plan, const std::map<std::string, batch::RunResult>& results);

void printStatus(const batch::Plan& plan, const batch::Store& store, std::ostream& out);

}  // namespace ariadne::experiment_app
