// One row of a tile, 32 cells, at a time: adds evidence for free to the cells of a mask, saturating
// at kMostFree. Rows are aligned to sixteen everywhere here.
#pragma once
#include <cstdint>

#include "ariadne/grid/tiles/log_odds.h"
#include "ariadne/grid/tiles/tiled_plane.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ariadne::grid {

static_assert(kTileCells == 32, "a row is two registers of sixteen cells, and one word of bits");

#if defined(__SSE2__)

/// Bit i: cell i of the row is occupied.
inline std::uint32_t occupiedOf(const std::int8_t* row) {
  const auto* p = reinterpret_cast<const __m128i*>(row);
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_load_si128(p))) |
         static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_load_si128(p + 1))) << 16;
}

/// Adds one amount to cells of a row.
class FreeLanes {
 public:
  explicit FreeLanes(std::int8_t amount) : amount_(_mm_set1_epi8(amount)) {}

  /// Adds. Bit i of the result: cell i went from occupied to not occupied.
  std::uint32_t add(std::int8_t* row, std::uint32_t cells) const {
    const Sums s(row, cells, amount_);
    auto* p = reinterpret_cast<__m128i*>(row);
    _mm_store_si128(p, s.after0);
    _mm_store_si128(p + 1, s.after1);
    const int freed0 = _mm_movemask_epi8(_mm_andnot_si128(s.after0, s.before0));
    const int freed1 = _mm_movemask_epi8(_mm_andnot_si128(s.after1, s.before1));
    return static_cast<std::uint32_t>(freed0) | static_cast<std::uint32_t>(freed1) << 16;
  }

 private:
  struct Sums {
    Sums(const std::int8_t* row, std::uint32_t cells, __m128i amount)
        : before0(_mm_load_si128(reinterpret_cast<const __m128i*>(row))),
          before1(_mm_load_si128(reinterpret_cast<const __m128i*>(row) + 1)) {
      // Each of the four bytes eight times, then one bit of each.
      __m128i v = _mm_cvtsi32_si128(static_cast<int>(cells));
      v = _mm_unpacklo_epi8(v, v);
      v = _mm_unpacklo_epi16(v, v);
      const __m128i bit = _mm_set1_epi64x(static_cast<long long>(0x8040201008040201U));
      const __m128i bits0 = _mm_and_si128(_mm_unpacklo_epi32(v, v), bit);
      const __m128i bits1 = _mm_and_si128(_mm_unpackhi_epi32(v, v), bit);
      after0 = _mm_adds_epi8(before0, _mm_and_si128(_mm_cmpeq_epi8(bits0, bit), amount));
      after1 = _mm_adds_epi8(before1, _mm_and_si128(_mm_cmpeq_epi8(bits1, bit), amount));
    }
    __m128i before0, before1, after0, after1;
  };
  __m128i amount_;
};

#else

inline std::uint32_t occupiedOf(const std::int8_t* row) {
  std::uint32_t occupied = 0;
  for (int i = 0; i < kTileCells; ++i) occupied |= static_cast<std::uint32_t>(row[i] < 0) << i;
  return occupied;
}

class FreeLanes {
 public:
  explicit FreeLanes(std::int8_t amount) : amount_(amount) {}
  std::uint32_t add(std::int8_t* row, std::uint32_t cells) const {
    const std::uint32_t before = occupiedOf(row);
    for (int i = 0; i < kTileCells; ++i)
      if ((cells >> i & 1U) != 0) row[i] = added(row[i]);
    return before & ~occupiedOf(row);
  }

 private:
  std::int8_t added(std::int8_t v) const {
    const int sum = v + amount_;
    return static_cast<std::int8_t>(sum > kMostFree ? kMostFree : sum);
  }
  std::int8_t amount_;
};

#endif

}  // namespace ariadne::grid
