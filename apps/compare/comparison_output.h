// A comparison as text and as JSON.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "comparison.h"
#include "requirement.h"

namespace ariadne::compare_app {

/// A figure with four significant digits.
std::string numberText(double value);

/// "median (least to largest)", or the one value.
std::string spreadText(const std::vector<double>& values);

/// How often both ran and what the table's figures are, as a sentence.
std::string repeatsText(const Comparison& comparison);

/// The table and a line a requirement.
std::string comparisonText(const Comparison& comparison,
                           const std::vector<Requirement>& requirements);

/// Every value of every repeat too; a ratio that is no number is null.
nlohmann::ordered_json comparisonJson(const Comparison& comparison,
                                      const std::vector<Requirement>& requirements);

}  // namespace ariadne::compare_app
