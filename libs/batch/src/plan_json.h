// The plan as plan.json, without the INIs, which lie beside it.
#pragma once
#include <string>

#include "ariadne/batch/plan.h"

namespace ariadne::batch {

/// The same plan is the same bytes.
std::string planText(const Plan& plan);
/// Throws core::Error that calls the file `name` when the text is no plan.
Plan parsePlan(const std::string& text, const std::string& name);

}  // namespace ariadne::batch
