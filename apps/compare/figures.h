// The figures of one run that are compared.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ariadne/process/process.h"

namespace ariadne::compare_app {

struct FigureKind {
  std::string stem;  ///< as in stem_ratio
  std::string unit;  ///< may be empty
  std::string about;
  std::string name() const { return unit.empty() ? stem : stem + "_" + unit; }
};

/// What a path is compared with; empty names: nothing.
struct References {
  std::string truth;      ///< TUM
  std::string relations;  ///< .gz or not
  double max_gap_s = 1;   ///< between two poses that are interpolated between
};

/// In the order of the table: costs, filter, path, and the errors for which there is a reference.
std::vector<FigureKind> figureKinds(const References& references);

/// By name.
using Figures = std::map<std::string, double>;

/// Of a finished run of ariadne-slam, from the files in its folder.
/// Neff counts as 1 of N where it was resampled, as stock tells it.
/// Throws core::Error naming the file that is missing or makes no sense.
Figures figuresOfOurs(const std::filesystem::path& folder, const process::ProcessEnd& costs,
                      const References& references);

/// Of ariadne-stock-rbpf, which wrote path.tum and summary.json into the folder.
Figures figuresOfStock(const std::filesystem::path& folder, const process::ProcessEnd& costs,
                       const References& references);

}  // namespace ariadne::compare_app
