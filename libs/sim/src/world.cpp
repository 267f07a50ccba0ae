#include "ariadne/sim/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "script_lines.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

using mrpt::math::TPoint2D;

constexpr double kMargin_m = 1;
constexpr double kLongestSide_m = 500;

struct Start {
  ScriptLine line;
  mrpt::math::TPose2D pose;
};

/// The text's commands, checked one by one.
struct Drawing {
  std::optional<double> resolution_m;
  std::optional<Start> start;
  std::vector<Block> blocks;
  std::vector<Block> glass;
};

std::vector<Block> corridorOf(const ScriptLine& line) {
  const char* usage = "corridor WIDTH x y x y ...";
  if (!line.words.empty() && line.words.size() % 2 == 0)
    throw lineError(line, fmt::format("an odd count of coordinates, {}; points are pairs: {}",
                                      line.words.size() - 1, usage));
  if (line.words.size() < 5)
    throw lineError(line, fmt::format("it takes a width and two points at least: {}", usage));
  const double width_m = numberIn(line, line.words[0], "the width", {0.1, 100});
  const auto values = coordinates(line, 1);
  std::vector<TPoint2D> points;
  for (std::size_t i = 0; i < values.size(); i += 2) points.emplace_back(values[i], values[i + 1]);
  return corridorBlocks(width_m, points);
}

Block rectangleOf(const ScriptLine& line, bool rock) {
  expectWords(line, 4, line.command + " x0 y0 x1 y1");
  const auto v = coordinates(line);
  if (v[0] == v[2] || v[1] == v[3])
    throw lineError(line, "the rectangle has no area: its corners must differ in x and in y");
  return rectangle(v[0], v[1], v[2], v[3], rock);
}

Start startOf(const ScriptLine& line) {
  expectWords(line, 3, "start x y deg");
  const auto v = coordinates(line);
  return {line, {v[0], v[1], std::remainder(v[2] * M_PI / 180, 2 * M_PI)}};
}

void readLine(const ScriptLine& line, Drawing& drawing) {
  const auto once = [&](bool there) {
    if (there) throw lineError(line, "a second one; a world has one");
  };
  if (line.command == "corridor") {
    for (const Block& block : corridorOf(line)) drawing.blocks.push_back(block);
  } else if (line.command == "room" || line.command == "wall") {
    drawing.blocks.push_back(rectangleOf(line, line.command == "wall"));
  } else if (line.command == "glass") {
    drawing.glass.push_back(rectangleOf(line, true));
  } else if (line.command == "start") {
    once(drawing.start.has_value());
    drawing.start = startOf(line);
  } else if (line.command == "resolution_m") {
    once(drawing.resolution_m.has_value());
    expectWords(line, 1, "resolution_m 0.05");
    drawing.resolution_m = numberIn(line, line.words[0], "the resolution", {0.01, 0.5});
  } else {
    throw unknownCommand(line, {"resolution_m", "corridor", "room", "wall", "glass", "start"});
  }
}

mrpt::maps::COccupancyGridMap2D rockAround(const Drawing& drawing, const std::string& name) {
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const Block& b : drawing.blocks) {
    if (b.rock) continue;
    left = std::min(left, b.x - b.reachX());
    right = std::max(right, b.x + b.reachX());
    bottom = std::min(bottom, b.y - b.reachY());
    top = std::max(top, b.y + b.reachY());
  }
  if (left > right)
    throw core::Error(name + ": nothing is carved; a world has a corridor or a room at least");
  const double resolution_m = drawing.resolution_m.value_or(0.05);
  const double width = right - left, height = top - bottom;
  if (width > kLongestSide_m || height > kLongestSide_m)
    throw core::Error(fmt::format("{}: {:.0f} x {:.0f} m are carved; a world has {} x {} m at most",
                                  name, width, height, kLongestSide_m, kLongestSide_m));
  const double cells =
      (width + 2 * kMargin_m) * (height + 2 * kMargin_m) / (resolution_m * resolution_m);
  if (cells > kMostCells)
    throw core::Error(
        fmt::format("{}: {:.3g} cells, over {:.0e}; a coarser resolution_m than {} "
                    "or a smaller world would do",
                    name, cells, kMostCells, resolution_m));
  const auto f = [](double value) { return static_cast<float>(value); };
  mrpt::maps::COccupancyGridMap2D map(f(left - kMargin_m), f(right + kMargin_m),
                                      f(bottom - kMargin_m), f(top + kMargin_m), f(resolution_m));
  map.fill(kRock);
  return map;
}

void checkStart(const World& world, const Start& start) {
  const auto& map = world.map;
  const double x = start.pose.x, y = start.pose.y;
  // Beyond the map getPos() says 0.5.
  if (!(map.getPos(static_cast<float>(x), static_cast<float>(y)) > 0.5F))
    throw lineError(start.line, fmt::format("({}, {}) is in rock; a robot starts where a corridor "
                                            "or a room was carved",
                                            x, y));
}

}  // namespace

World parseWorld(std::string_view text, const std::string& name) {
  Drawing drawing;
  for (const ScriptLine& line : scriptLines(text, name)) readLine(line, drawing);
  World world;
  world.name = name;
  world.map = rockAround(drawing, name);
  for (const Block& block : drawing.blocks) paint(world.map, block);
  world.bodies = world.map;
  for (const Block& block : drawing.glass) paint(world.bodies, block);
  if (!drawing.start)
    throw core::Error(name + ": the robot's start is missing; a line `start x y deg` sets it");
  checkStart(world, *drawing.start);
  world.start = drawing.start->pose;
  return world;
}

}  // namespace ariadne::sim
