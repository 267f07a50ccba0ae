// Worlds drawn from a seed, so that nobody tunes a robot to a handful of pictures.
#pragma once
#include <cstdint>
#include <string>

#include "ariadne/core/fields.h"

namespace ariadne::sim {

/// What is drawn: `office`: a ring of corridors without niches, corridors across it, furnished
/// rooms with doors of 0.8 to 1 m on both sides, some with a glass front, and a hall of pillars;
/// `corridors`: the same corridors alone, bare.
enum class RandomWorld { none, office, corridors };

/// Their names on the command line and in INIs.
inline core::Choices<RandomWorld> randomWorlds() {
  return {{"none", RandomWorld::none},
          {"office", RandomWorld::office},
          {"corridors", RandomWorld::corridors}};
}

/// The text of a world (world.h): 24 to 44 m wide, 20 to 36 m deep. The same seed gives the same
/// text on any machine; `none` gives an empty one. Any robot that passes a gap of 0.7 m reaches all
/// of the floor but what furniture closes in.
std::string randomWorld(RandomWorld kind, std::uint64_t seed);

}  // namespace ariadne::sim
