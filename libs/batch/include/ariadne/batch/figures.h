// Figures from what the programs write.
#pragma once
#include <filesystem>
#include <string>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/success.h"

namespace ariadne::batch {

/// Numbers and truth values of a summary.json by their path, as `costs.cpu_s`; lists, texts and
/// `parameters` are left out. Throws core::Error that calls the text `name` when it is no JSON.
Figures figuresOfSummary(const std::string& json, const std::string& name);

/// The one row of a CSV file, by its header; empty and text cells are left out.
Figures figuresOfRow(const std::string& csv, const std::string& name);

/// What ariadne-stock-rbpf prints, by the names that our programs give the same.
Figures figuresOfStock(const std::string& printed, const std::string& name);

/// In a run's folder: what its program printed, where figures are in that.
inline constexpr const char* kPrintedFile = "printed.txt";

/// Of a finished run in its folder, with ate_rmse_m of its trajectory.tum (after alignment) where
/// the arm names a truth. Throws core::Error when its result is not there.
Figures figuresOf(const PlannedArm& arm, const std::filesystem::path& out);

}  // namespace ariadne::batch
