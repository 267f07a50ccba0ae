// Plots in gnuplot's language.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/batch/plot_data.h"

namespace ariadne::batch {

/// Draws every plot twice: NAME.svg and NAME.png of the folder.
std::string gnuplotScript(const std::vector<Plot>& plots, const std::filesystem::path& folder);

}  // namespace ariadne::batch
