// How far an experiment is, and what failed.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::experiment_app {

void printStatus(const batch::Plan& plan, const batch::Store& store, std::ostream& out);

}  // namespace ariadne::experiment_app
