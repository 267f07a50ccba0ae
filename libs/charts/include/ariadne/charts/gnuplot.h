// Charts that stand still, drawn by gnuplot, a program of its own.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ariadne/core/error.h"

namespace ariadne::charts {

/// gnuplot is not installed. Who can do without the chart catches it.
struct GnuplotMissing : core::Error {
  using core::Error::Error;
};

/// The bytes of the files that a script draws, in the order of their names.
/// @param script gnuplot's language; given a folder of its own, to which it draws these files
/// Throws GnuplotMissing naming the package, core::Error with what gnuplot says when it fails. The
/// same script gives the same bytes.
std::vector<std::string> drawnFiles(
    const std::vector<std::string>& names,
    const std::function<std::string(const std::filesystem::path& folder)>& script);

}  // namespace ariadne::charts
