// What each filter update did as JSON, a column a quantity.
#pragma once
#include <nlohmann/json.hpp>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Units are in the names; null where there is no value. "loop" and "state" are runs of equal
/// values: [first step, value].
nlohmann::ordered_json stepsJson(const Replay& replay);

}  // namespace ariadne::report
