#include "ariadne/eval/map_entropy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace ariadne::eval {
namespace {

using grid::CellBox;
using grid::kTileCells;
using Plane = grid::EvidencePlane;

const double kLn2 = std::log(2.0);

/// By log odds as an unsigned byte. Unknown cells are 0 here and counted apart.
const std::array<double, 256>& entropyTable() {
  static const auto table = [] {
    std::array<double, 256> t{};
    for (int l = -128; l < 128; ++l)
      t[static_cast<std::uint8_t>(l)] = l == 0 ? 0 : cellEntropy(static_cast<std::int8_t>(l));
    return t;
  }();
  return table;
}

struct TileSum {
  double known = 0;  // nats
  int unknown = 0;   // cells
};

/// Cells of `part`, in the tile's own coordinates.
TileSum sumOf(const Plane::Cells& cells, const CellBox& part) {
  const auto& table = entropyTable();
  TileSum sum;
  for (int y = part.y0; y < part.y1; ++y)
    for (int x = part.x0; x < part.x1; ++x) {
      const std::int8_t l = cells[grid::tileOffset(x, y)];
      sum.known += table[static_cast<std::uint8_t>(l)];
      sum.unknown += l == 0;
    }
  return sum;
}

/// Sums of whole tiles, by address: particles share most of theirs.
using Cache = std::unordered_map<const grid::EvidenceTile*, TileSum>;

double entropyOf(const grid::OccupancyGrid& map, const CountedCells& cells, Cache& cache) {
  double known = 0;
  double unknown = 0;  // cells of the box
  if (cells.box && !cells.box->empty())
    unknown =
        (double{1} * cells.box->x1 - cells.box->x0) * (double{1} * cells.box->y1 - cells.box->y0);
  map.cells().forEachPacked([&](int tx, int ty, const grid::EvidenceTile& tile) {
    CellBox part{0, 0, kTileCells, kTileCells};
    if (cells.box) {
      const int x = tx * kTileCells;
      const int y = ty * kTileCells;
      part = {std::clamp(cells.box->x0, x, x + kTileCells) - x,
              std::clamp(cells.box->y0, y, y + kTileCells) - y,
              std::clamp(cells.box->x1, x, x + kTileCells) - x,
              std::clamp(cells.box->y1, y, y + kTileCells) - y};
      if (part.empty()) return;
    }
    const int count = (part.x1 - part.x0) * (part.y1 - part.y0);
    TileSum sum;
    if (count == kTileCells * kTileCells) {
      const auto [found, is_new] = cache.try_emplace(&tile);
      if (is_new) found->second = sumOf(map.cells().cellsOf(tile), part);
      sum = found->second;
    } else {
      sum = sumOf(map.cells().cellsOf(tile), part);
    }
    known += sum.known;
    unknown -= count - sum.unknown;
  });
  return cells.box ? known + unknown * kLn2 : known;
}

}  // namespace

double cellEntropy(std::int8_t log_odds) {
  const double l = std::abs(log_odds) / 16.0;  // free and occupied are alike
  // ln(1 + e^-l) + l (1 - p), p = 1 / (1 + e^-l): the textbook's sum without its 0 ln 0.
  const double e = std::exp(-l);
  return std::log1p(e) + l * e / (1 + e);
}

double mapEntropy(const grid::OccupancyGrid& map, const CountedCells& cells) {
  Cache cache;
  return entropyOf(map, cells, cache);
}

double tileEntropy(const Plane::Cells& cells) {
  const auto& table = entropyTable();
  // Four sums that do not wait for each other: three times as quick as one.
  std::array<double, 4> sums{};
  for (std::size_t i = 0; i < cells.size(); i += 4)
    for (std::size_t j = 0; j < 4; ++j) sums[j] += table[static_cast<std::uint8_t>(cells[i + j])];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

std::vector<double> mapEntropies(const std::vector<const grid::OccupancyGrid*>& maps,
                                 const CountedCells& cells) {
  Cache cache;
  std::vector<double> all;
  all.reserve(maps.size());
  for (const auto* map : maps) all.push_back(entropyOf(*map, cells, cache));
  return all;
}

}  // namespace ariadne::eval
