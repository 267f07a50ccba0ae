// Four rows of a tile at a time: 128 cells as the bits of one register. GCC's and Clang's vector
// types, so that every processor has them.
#pragma once
#include <cstdint>
#include <cstring>

#include "ariadne/grid/tiles/tiled_plane.h"

namespace ariadne::grid {

using Lanes = std::uint32_t __attribute__((vector_size(16), may_alias));
constexpr int kRowsOfLanes = 4;
constexpr int kLanes = kTileCells / kRowsOfLanes;  ///< of a tile

/// Rows must be aligned to 16 bytes.
inline const Lanes& lanes(const std::uint32_t* rows, int i) {
  return *reinterpret_cast<const Lanes*>(rows + i * kRowsOfLanes);
}
inline Lanes& lanes(std::uint32_t* rows, int i) {
  return *reinterpret_cast<Lanes*>(rows + i * kRowsOfLanes);
}

inline bool any(const Lanes& v) {
  std::uint64_t words[2];
  std::memcpy(words, &v, sizeof(words));
  return (words[0] | words[1]) != 0;
}

}  // namespace ariadne::grid
