#include "ariadne/sim/random_world.h"

#include <fmt/format.h>

#include <vector>

#include "random_rooms.h"

namespace ariadne::sim {
namespace {

/// Corridors that meet at right angles: a ring, and some across it.
struct Corridors {
  double width_m;
  Rectangle outside;       ///< of the whole building
  Rectangle ring;          ///< middle lines of the ring
  std::vector<double> xs;  ///< middle lines of the corridors across, from left to right
};

Corridors drawCorridors(Dice& dice, double band_m) {
  Corridors c;
  c.width_m = dice.between(1.8, 2.4);
  c.outside = {0, 0, dice.between(24, 44), dice.between(20, 36)};
  c.ring = c.outside.shrunk(band_m + c.width_m / 2);
  const int across = dice.upTo(c.ring.width() > 24 ? 2 : 1);
  for (int i = 1; i <= across; ++i)
    c.xs.push_back(c.ring.x0 + c.ring.width() * (i + dice.between(-0.2, 0.2)) / (across + 1));
  return c;
}

std::string textOf(const Corridors& c) {
  const Rectangle& r = c.ring;
  std::string text = fmt::format(
      "corridor {:.2f}  {:.2f} {:.2f}  {:.2f} {:.2f}  {:.2f} {:.2f}  "
      "{:.2f} {:.2f}  {:.2f} {:.2f}\n",
      c.width_m, r.x0, r.y0, r.x1, r.y0, r.x1, r.y1, r.x0, r.y1, r.x0, r.y0);
  for (const double x : c.xs)
    text +=
        fmt::format("corridor {:.2f}  {:.2f} {:.2f}  {:.2f} {:.2f}\n", c.width_m, x, r.y0, x, r.y1);
  return text;
}

/// Rooms outside the ring and inside it; the corners of the building stay closed.
std::string roomsAlong(const Corridors& c, double band_m, Dice& dice) {
  const Rectangle& o = c.outside;
  std::string text;
  text += rowOfRooms({o.x0 + band_m, o.y0, o.x1 - band_m, o.y0 + band_m}, Side::top, dice);
  text += rowOfRooms({o.x0 + band_m, o.y1 - band_m, o.x1 - band_m, o.y1}, Side::bottom, dice);
  text += rowOfRooms({o.x0, o.y0 + band_m, o.x0 + band_m, o.y1 - band_m}, Side::right, dice);
  text += rowOfRooms({o.x1 - band_m, o.y0 + band_m, o.x1, o.y1 - band_m}, Side::left, dice);
  const Rectangle in = c.ring.shrunk(c.width_m / 2);
  double left = in.x0;
  for (std::size_t i = 0; i <= c.xs.size(); ++i) {
    const double right = i < c.xs.size() ? c.xs[i] - c.width_m / 2 : in.x1;
    text += blockOfRooms({left, in.y0, right, in.y1}, dice);
    if (i < c.xs.size()) left = c.xs[i] + c.width_m / 2;
  }
  return text;
}

}  // namespace

std::string randomWorld(RandomWorld kind, std::uint64_t seed) {
  if (kind == RandomWorld::none) return "";
  Dice dice(seed);
  const bool office = kind == RandomWorld::office;
  const double band_m = office ? dice.between(4, 6) : 0;
  const Corridors corridors = drawCorridors(dice, band_m);
  std::string text =
      fmt::format("# ariadne-dataset world --random {} --seed {}\nstart {:.2f} {:.2f} 0\n",
                  office ? "office" : "corridors", seed, corridors.ring.x0, corridors.ring.y0);
  text += textOf(corridors);
  if (office) text += roomsAlong(corridors, band_m, dice);
  return text;
}

}  // namespace ariadne::sim
