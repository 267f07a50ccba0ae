// What squeue, sacct and GNU parallel's log say about a results folder.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::experiment_app {

/// Prints nothing for a folder that was never handed to a cluster; commands that are missing or do
/// not answer are told, not thrown.
void printClusterStatus(const batch::Plan& plan, const batch::Store& store, std::ostream& out);

}  // namespace ariadne::experiment_app
