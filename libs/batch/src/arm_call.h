// What an arm's program is called with at one combination of the factors' values.
#pragma once
#include <string>
#include <vector>

#include "ariadne/batch/experiment.h"
#include "ariadne/batch/program.h"

namespace ariadne::batch {

/// A value of every factor.
using Combination = std::vector<std::string>;

ArmCall callOf(const Experiment& x, const Arm& arm, const Combination& values);

/// Path of the arm's truth, or nothing. Throws core::UsageError when it cannot be read.
std::string truthOf(const Experiment& x, const Arm& arm);

/// Throws core::UsageError for a file that is not there and for what the program cannot take.
void checkCall(const Arm& arm, const Program& program, const ArmCall& call);

}  // namespace ariadne::batch
