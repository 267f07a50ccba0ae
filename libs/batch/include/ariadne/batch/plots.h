// Plots drawn by gnuplot, a program of its own.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/batch/plot_data.h"

namespace ariadne::batch {

/// A plot as it was drawn: the bytes of both files.
struct Picture {
  std::string name;  ///< as Plot's
  std::string svg;   ///< the same bytes for the same plot and gnuplot
  std::string png;
};

/// In the plots' order. Throws core::Error naming the package when gnuplot is missing, and with
/// what it says when it fails.
std::vector<Picture> drawPlots(const std::vector<Plot>& plots);

/// NAME.svg and NAME.png of the folder, which is made unless there is nothing to write. Throws
/// core::Error.
void writePictures(const std::vector<Picture>& pictures, const std::filesystem::path& folder);

}  // namespace ariadne::batch
