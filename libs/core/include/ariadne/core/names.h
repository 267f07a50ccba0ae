// Names and values in error messages: what is nearest, and what can be printed.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::core {

/// For messages: control bytes as \xNN, cut to a readable length.
std::string printable(std::string_view text);

/// The name with the least edit distance (case counts little); empty when there are none.
std::string nearestName(std::string_view name, const std::vector<std::string>& known);

/// Of ASCII letters; others must be the same.
bool equalIgnoringCase(std::string_view a, std::string_view b);

}  // namespace ariadne::core
