// Sixteen cells at a time: adds a beam's evidence for free, saturating at kMostFree.
#pragma once
#include <cstdint>

#include "ariadne/grid/log_odds.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ariadne::grid {

constexpr int kLanes = 16;

#if defined(__SSE2__)

/// True when all sixteen cells hold kMostFree. Cells are aligned to sixteen everywhere here.
inline bool allMostFree(const std::int8_t* cells) {
  const __m128i v = _mm_load_si128(reinterpret_cast<const __m128i*>(cells));
  return _mm_movemask_epi8(_mm_cmpeq_epi8(v, _mm_set1_epi8(kMostFree))) == 0xFFFF;
}

/// Adds one amount to lanes [begin, end) of sixteen cells.
class FillLanes {
 public:
  explicit FillLanes(std::int8_t amount) : amount_(amount) {
    for (int i = 0; i < 48; ++i) window_[i] = i >= 16 && i < 32 ? amount : std::int8_t{0};
  }
  int amount() const { return amount_; }
  /// Whether any cell would change; nothing is written yet, since a write may copy the tile.
  bool changes(const std::int8_t* cells, int begin, int end) const {
    const __m128i before = _mm_load_si128(reinterpret_cast<const __m128i*>(cells));
    const __m128i after = _mm_adds_epi8(before, addend(begin, end));
    return _mm_movemask_epi8(_mm_cmpeq_epi8(before, after)) != 0xFFFF;
  }
  /// Adds. Bit i of the result: cell i went from occupied to not occupied.
  unsigned add(std::int8_t* cells, int begin, int end) const {
    __m128i* p = reinterpret_cast<__m128i*>(cells);
    const __m128i before = _mm_load_si128(p);
    const __m128i after = _mm_adds_epi8(before, addend(begin, end));
    _mm_store_si128(p, after);
    return static_cast<unsigned>(_mm_movemask_epi8(_mm_andnot_si128(after, before)));
  }

 private:
  __m128i at(int i) const { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(window_ + i)); }
  __m128i addend(int begin, int end) const { return _mm_and_si128(at(16 - begin), at(32 - end)); }

  std::int8_t amount_;
  alignas(16) std::int8_t window_[48];  // sixteen amounts between zeros, read at an offset
};

#else

inline bool allMostFree(const std::int8_t* cells) {
  bool all = true;
  for (int i = 0; i < kLanes; ++i) all &= cells[i] == kMostFree;
  return all;
}

class FillLanes {
 public:
  explicit FillLanes(std::int8_t amount) : amount_(amount) {}
  int amount() const { return amount_; }
  bool changes(const std::int8_t* cells, int begin, int end) const {
    for (int i = begin; i < end; ++i)
      if (added(cells[i]) != cells[i]) return true;
    return false;
  }
  unsigned add(std::int8_t* cells, int begin, int end) const {
    unsigned freed = 0;
    for (int i = begin; i < end; ++i) {
      if (cells[i] < 0 && added(cells[i]) >= 0) freed |= 1U << i;
      cells[i] = added(cells[i]);
    }
    return freed;
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
