// Whether what submit was asked for can be had, before anything is planned or written.
#pragma once
#include <iosfwd>

#include "ariadne/batch/plan.h"
#include "experiment_options.h"

namespace ariadne::experiment_app {

/// Throws core::UsageError: an option that is no good, a program that is missing and its package.
void checkSubmit(const Options& options);

/// On `err`, when a task may end before a single run of it has to.
void warnOfTime(const Options& options, const batch::Plan& plan, std::ostream& err);

}  // namespace ariadne::experiment_app
