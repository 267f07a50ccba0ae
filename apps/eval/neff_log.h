// How Neff falls over a recorded drive, on new ground and where a place is driven again: with plain
// weights and with evidence that counts less at each revisit of a place.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::eval_app {

/// Writes the PNG: fall of ln Neff summed over the drive, mean of the runs. Returns the table,
/// Markdown: fall and resamplings by how often the place had been passed.
/// @param truth TUM file; the others are steps.csv of one drive, a seed each
/// Throws core::Error naming the file.
std::string neffOfLog(const std::filesystem::path& png, const std::filesystem::path& truth,
                      const std::vector<std::string>& plain,
                      const std::vector<std::string>& revisit);

}  // namespace ariadne::eval_app
