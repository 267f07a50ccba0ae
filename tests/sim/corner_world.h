// A small world to drive in: an L of corridor with a room, 16 x 10 m.
#pragma once
#include "ariadne/sim/drive.h"

namespace ariadne::test {

inline sim::World cornerWorld() {
  return sim::parseWorld("corridor 2 0 0 12 0 12 6\nroom 3 1 6 3\nwall 8 0.7 8.4 1\nstart 0 0 0",
                         "corner.world");
}

inline sim::DrivePath cornerPath(std::optional<int> laps = {}) {
  return sim::parsePath(
      "laps 1\nmark A\ngoto 12 0\nmark corner\ngoto 12 5\n"
      "repeat laps\ngoto 12 0\ngoto 12 5\nend\nmark end",
      "corner.path", laps);
}

}  // namespace ariadne::test
