// The plan shown before anything is run.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::experiment_app {

/// Runs by arm and combination, and an estimate of time and disk by what is finished.
/// @param store nothing: no results folder was named
void printPlan(const batch::Plan& plan, const batch::Store* store, int jobs, std::ostream& out);

}  // namespace ariadne::experiment_app
