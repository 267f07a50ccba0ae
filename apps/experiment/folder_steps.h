// Steps that several commands of ariadne-experiment take in a results folder.
#pragma once
#include <set>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"
#include "experiment_options.h"

namespace ariadne::experiment_app {

/// The plan of the experiment's INI with the seeds asked for. Throws core::UsageError, core::Error.
batch::Plan planFor(const Options& options);

/// Drops the results of runs that failed, so that they are done again. Returns their keys.
std::set<std::string> forgetFailed(const batch::Plan& plan, const batch::Store& store);

}  // namespace ariadne::experiment_app
