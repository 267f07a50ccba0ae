// The tables of an experiment that was handed to a cluster.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::experiment_app {

/// Writes FOLDER/tables, in all formats, and prints the text; the same bytes as `table` and `run`
/// give. Returns the exit code: 1 with nothing written when a run has no result, 1 when one failed.
int collect(const batch::Plan& plan, const batch::Store& store, std::ostream& out,
            std::ostream& err);

}  // namespace ariadne::experiment_app
