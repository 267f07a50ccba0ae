// Charts that stand still, drawn by gnuplot, a program of its own.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ariadne::charts {

/// The bytes of the files that a script draws, in the order of their names.
/// @param script gnuplot's language; given a folder of its own, to which it draws these files
/// Throws core::Error naming the package when gnuplot is missing, and with what it says when it
/// fails. The same script gives the same bytes.
std::vector<std::string> drawnFiles(
    const std::vector<std::string>& names,
    const std::function<std::string(const std::filesystem::path& folder)>& script);

}  // namespace ariadne::charts
