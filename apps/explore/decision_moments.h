// The explorer's decisions as moments of report.html, and what it sees as a scene to draw.
#pragma once
#include "ariadne/explore/explorer.h"
#include "ariadne/report/replay.h"

namespace ariadne::explore_app {

report::ReplayMoment momentOf(const explore::Decision& decision);

/// Frontiers, route, goal, and the shortcut to the entry while the robot drives there.
report::ReplayScene sceneOf(const explore::Explorer& explorer, const slam::Mapper& mapper);

}  // namespace ariadne::explore_app
