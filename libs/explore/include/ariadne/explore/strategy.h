// The comparison explorers of the paper, by name.
#pragma once
#include "ariadne/explore/params.h"
#include "ariadne/slam/params.h"

namespace ariadne::explore {

/// Sets what a strategy decides about the mapping: which rule ends a closing and whether diversity
/// is recovered afterwards. `frontier` never drives a loop on purpose; what it closes in passing
/// ends as on a recorded log.
void applyStrategy(Strategy strategy, slam::SlamParams& params);

/// Whether loops are closed on purpose.
bool isActive(Strategy strategy);

}  // namespace ariadne::explore
