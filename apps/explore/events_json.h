// events.json: every decision of the explorer with the numbers it was made on.
#pragma once
#include <string>
#include <vector>

#include "ariadne/explore/decision.h"

namespace ariadne::explore_app {

std::string eventsJson(const std::vector<explore::Decision>& decisions);

}  // namespace ariadne::explore_app
