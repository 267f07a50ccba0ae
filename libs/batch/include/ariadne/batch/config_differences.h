// In which keys the arms of an experiment differ.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"

namespace ariadne::batch {

/// A key that has not the same value in every arm.
struct KeyDifference {
  std::string key;                  ///< section.key, "program" or "arguments"
  std::vector<std::string> values;  ///< of each arm; what factors change: "15, 30"; empty: none
};

/// Program and arguments first, then keys in the order in which INIs name them. [run], which does
/// not change results, is left out.
/// @param configs resolved INIs by hash; one that is none of ours has no keys
std::vector<KeyDifference> differencesOf(const Plan& plan,
                                         const std::map<std::string, std::string>& configs);

}  // namespace ariadne::batch
