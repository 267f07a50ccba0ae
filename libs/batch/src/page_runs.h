// Single runs on an experiment's page.
#pragma once
#include <string>

#include "ariadne/batch/experiment_page.h"

namespace ariadne::batch {

/// Those that failed, with their last words.
std::string failedHtml(const Outcome& outcome);

/// All, an arm at one combination of values at a time, with figures and links to kept pages.
std::string runsHtml(const Outcome& outcome, const Store& store);

}  // namespace ariadne::batch
