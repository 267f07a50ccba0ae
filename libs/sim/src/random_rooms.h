// The rooms of a random office.
#pragma once
#include <string>

#include "ariadne/core/random.h"

namespace ariadne::sim {

/// Draws that depend on the seed of the world alone.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : rng_(seed, 0, 0, core::Purpose::world) {}
  double between(double low, double high) { return low + (high - low) * rng_.uniform(); }
  /// 0 to most, each as likely.
  int upTo(int most) { return static_cast<int>(rng_.uniform() * (most + 1)); }
  bool chance(double p) { return rng_.uniform() < p; }

 private:
  core::RandomStream rng_;
};

/// m, frame of the world.
struct Rectangle {
  double x0, y0, x1, y1;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  Rectangle shrunk(double by) const { return {x0 + by, y0 + by, x1 - by, y1 - by}; }
};

/// Where the corridor lies, seen from a room.
enum class Side { left, right, bottom, top };

/// Rooms beside each other that fill a band, each with a door to the corridor on `side`; lines of a
/// .world.
std::string rowOfRooms(const Rectangle& band, Side side, Dice& dice);

/// What corridors enclose: two rows of rooms back to back, or a hall with pillars.
std::string blockOfRooms(const Rectangle& block, Dice& dice);

}  // namespace ariadne::sim
