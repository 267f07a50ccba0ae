// A replay as the JSON that page/*.js reads: whole numbers of small units, keyframes as what is
// new since the one before.
#pragma once
#include <string>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Valid within <script>: no "<" in it. Bytes that are no UTF-8 are replaced.
std::string replayJson(const Replay& replay);

}  // namespace ariadne::report
