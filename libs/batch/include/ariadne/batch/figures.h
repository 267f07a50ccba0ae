// Figures from what the programs write.
#pragma once
#include <filesystem>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/success.h"

namespace ariadne::batch {

/// Numbers and truth values of a summary.json by their path, as `costs.cpu_s`; a null is NaN;
/// lists, texts and `parameters` are left out. Throws core::Error that calls the text `name` when
/// it is no JSON.
Figures figuresOfSummary(const std::string& json, const std::string& name);

/// Of a finished run in its folder, with ate_rmse_m of its trajectory.tum (after alignment) where
/// the arm names a truth. Throws core::Error when its result is not there.
Figures figuresOf(const PlannedArm& arm, const std::filesystem::path& out);

}  // namespace ariadne::batch
