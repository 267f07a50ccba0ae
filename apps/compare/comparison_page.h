// A comparison as a page.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "comparison.h"
#include "requirement.h"

namespace ariadne::compare_app {

/// One HTML file without others: the table, the requirements, and both maps as pictures in it.
/// @param ours, stock PNG files; core::Error naming the one that cannot be read
std::string comparisonPage(const Comparison& comparison,
                           const std::vector<Requirement>& requirements,
                           const std::filesystem::path& ours, const std::filesystem::path& stock);

}  // namespace ariadne::compare_app
