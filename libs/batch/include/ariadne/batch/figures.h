// Figures from what the programs write.
#pragma once
#include <filesystem>
#include <string>

#include "ariadne/batch/program.h"
#include "ariadne/batch/success.h"

namespace ariadne::batch {

/// Numbers and truth values of a summary.json by their path, as `costs.cpu_s`; lists, texts and
/// `parameters` are left out. Throws core::Error that calls the text `name` when it is no JSON.
Figures figuresOfSummary(const std::string& json, const std::string& name);

/// The one row of a CSV file, by its header; empty and text cells are left out.
Figures figuresOfRow(const std::string& csv, const std::string& name);

/// What ariadne-stock-rbpf prints: scans, frames, cpu_s, peak_memory_mb.
Figures figuresOfStock(const std::string& printed, const std::string& name);

/// In a run's folder: what its program printed, where figures are in that.
inline constexpr const char* kPrintedFile = "printed.txt";

/// Of a finished run in its folder. Throws core::Error when its result is not there.
Figures figuresOf(ProgramKind kind, const std::filesystem::path& out);

}  // namespace ariadne::batch
