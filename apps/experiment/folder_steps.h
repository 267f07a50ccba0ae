// Steps that several commands of ariadne-experiment take in a results folder.
#pragma once
#include <map>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"
#include "ariadne/batch/text_table.h"
#include "experiment_options.h"

namespace ariadne::experiment_app {

/// The plan of the experiment's INI with the seeds asked for. Throws core::UsageError, core::Error.
batch::Plan planFor(const Options& options);

/// Drops the results of runs that failed, so that they are done again.
void forgetFailed(const batch::Plan& plan, const batch::Store& store);

/// Throws core::UsageError as batch::cellsOf.
std::string tableText(const batch::Plan& plan,
                      const std::map<std::string, batch::RunResult>& results,
                      batch::TableFormat format);

}  // namespace ariadne::experiment_app
