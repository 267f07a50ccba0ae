#include "random_rooms.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ariadne::sim {
namespace {

constexpr double kRoomWall_m = 0.15;
constexpr double kLeastRoom_m = 2.5;  // side of a room
constexpr double kPassage_m = 0.9;    // between pieces of furniture, and about a door

std::string lineOf(const char* command, const Rectangle& r) {
  return fmt::format("{} {:.2f} {:.2f} {:.2f} {:.2f}\n", command, r.x0, r.y0, r.x1, r.y1);
}

bool isAcross(Side side) { return side == Side::left || side == Side::right; }

/// The part of the wall on `side` of a room from `from` to `to` along it.
Rectangle inWall(const Rectangle& room, Side side, double from, double to) {
  switch (side) {
    case Side::left:
      return {room.x0 - kRoomWall_m, from, room.x0, to};
    case Side::right:
      return {room.x1, from, room.x1 + kRoomWall_m, to};
    case Side::bottom:
      return {from, room.y0 - kRoomWall_m, to, room.y0};
    case Side::top:
      break;
  }
  return {from, room.y1, to, room.y1 + kRoomWall_m};
}

bool apart(const Rectangle& a, const Rectangle& b, double by) {
  return a.x0 > b.x1 + by || b.x0 > a.x1 + by || a.y0 > b.y1 + by || b.y0 > a.y1 + by;
}

/// Desks and cupboards with their backs to a wall; the way from the door stays free.
std::string furniture(const Rectangle& room, const Rectangle& door, Dice& dice) {
  std::string text;
  std::vector<Rectangle> placed{door};
  for (int tries = 2 + dice.upTo(4); tries > 0; --tries) {
    const double along = dice.between(0.6, 1.6), deep = dice.between(0.4, 0.8);
    const auto side = static_cast<Side>(dice.upTo(3));
    const double w = isAcross(side) ? deep : along, h = isAcross(side) ? along : deep;
    if (room.width() < w + kPassage_m || room.height() < h + kPassage_m) continue;
    double x = dice.between(room.x0, room.x1 - w), y = dice.between(room.y0, room.y1 - h);
    if (side == Side::left) x = room.x0;
    if (side == Side::right) x = room.x1 - w;
    if (side == Side::bottom) y = room.y0;
    if (side == Side::top) y = room.y1 - h;
    const Rectangle piece{x, y, x + w, y + h};
    const auto free = [&](const Rectangle& other) { return apart(piece, other, kPassage_m); };
    if (!std::all_of(placed.begin(), placed.end(), free)) continue;
    placed.push_back(piece);
    text += lineOf("wall", piece);
  }
  return text;
}

/// A room with its door, its furniture, and now and then a front of glass.
std::string roomWithDoor(const Rectangle& room, Side side, Dice& dice) {
  const double low = isAcross(side) ? room.y0 : room.x0, high = isAcross(side) ? room.y1 : room.x1;
  const double width_m = dice.between(0.8, 1.0);
  const double from = dice.between(low + 0.2, high - width_m - 0.2);
  const Rectangle door = inWall(room, side, from, from + width_m);
  std::string text = lineOf("room", room) + lineOf("room", door);
  if (dice.chance(0.1)) {
    const double pane = high - 0.2;
    if (pane - (from + width_m + 0.2) > 0.5) {
      const Rectangle glass = inWall(room, side, from + width_m + 0.2, pane);
      text += lineOf("room", glass) + lineOf("glass", glass);
    }
  }
  return text + furniture(room, door, dice);
}

std::string hall(const Rectangle& block, Dice& dice) {
  const Rectangle room = block.shrunk(kRoomWall_m);
  std::string text = lineOf("room", room);
  for (const Side side : {Side::left, Side::right, Side::bottom, Side::top}) {
    const double low = isAcross(side) ? room.y0 : room.x0;
    const double high = isAcross(side) ? room.y1 : room.x1;
    const double from = dice.between(low + 0.3, high - 1.3);
    text += lineOf("room", inWall(room, side, from, from + dice.between(0.8, 1.0)));
  }
  const double half = dice.between(0.15, 0.25), apart_m = dice.between(3, 4);
  for (double x = room.x0 + apart_m / 2; x < room.x1 - 1; x += apart_m)
    for (double y = room.y0 + apart_m / 2; y < room.y1 - 1; y += apart_m)
      text += lineOf("wall", {x - half, y - half, x + half, y + half});
  return text;
}

}  // namespace

std::string rowOfRooms(const Rectangle& band, Side side, Dice& dice) {
  const bool up = isAcross(side);
  const double end = up ? band.y1 : band.x1;
  std::string text;
  for (double at = up ? band.y0 : band.x0; end - at > kLeastRoom_m + 2 * kRoomWall_m;) {
    double to = at + dice.between(3, 7);
    if (end - to < kLeastRoom_m + 2 * kRoomWall_m) to = end;
    const Rectangle cell =
        up ? Rectangle{band.x0, at, band.x1, to} : Rectangle{at, band.y0, to, band.y1};
    text += roomWithDoor(cell.shrunk(kRoomWall_m), side, dice);
    at = to;
  }
  return text;
}

std::string blockOfRooms(const Rectangle& block, Dice& dice) {
  constexpr double kTooThin_m = 3.5;
  if (std::min(block.width(), block.height()) < kTooThin_m) return "";
  if (dice.chance(0.3) && std::min(block.width(), block.height()) > 6) return hall(block, dice);
  if (block.height() < 2 * kTooThin_m) return rowOfRooms(block, Side::bottom, dice);
  const double middle = block.y0 + block.height() * dice.between(0.45, 0.55);
  return rowOfRooms({block.x0, block.y0, block.x1, middle}, Side::bottom, dice) +
         rowOfRooms({block.x0, middle, block.x1, block.y1}, Side::top, dice);
}

}  // namespace ariadne::sim
