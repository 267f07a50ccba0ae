// A keyframe as JSON, by what is new since the one before.
#pragma once
#include <nlohmann/json.hpp>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Positions in cm. Lists that mostly grow are [numbers to keep from before, new number, ...].
nlohmann::ordered_json frameJson(const ReplayFrame& frame, const ReplayFrame& before);

/// [step, then x, y (cm), heading (mrad), weight (hundredths of the largest) of each particle],
/// poses but the first as differences to the first.
nlohmann::ordered_json cloudJson(const ReplayCloud& cloud);

/// Rounded to a whole number; 0 for what is not finite, which JSON has no number for.
std::int64_t rounded(double value);

}  // namespace ariadne::report
