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

/// True when all sixteen cells hold kMostFree.
inline bool allMostFree(const std::int8_t* cells) {
  const __m128i v = _mm_load_si128(reinterpret_cast<const __m128i*>(cells));
  return _mm_movemask_epi8(_mm_cmpeq_epi8(v, _mm_set1_epi8(kMostFree))) == 0xFFFF;
}

class FillLanes {
 public:
  /// Adds `amount` to the lanes [begin, end) of sixteen.
  FillLanes(int begin, int end, std::int8_t amount) {
    alignas(16) static constexpr std::int8_t kStep[48] = {
        0,  0,  0,  0,  0,  0,  0,  0,  0, 0, 0, 0, 0, 0, 0, 0, -1, -1, -1, -1, -1, -1, -1, -1,
        -1, -1, -1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0,  0,  0,  0,  0,  0,  0};
    const auto at = [](int i) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i*>(kStep + i));
    };
    add_ = _mm_and_si128(_mm_and_si128(at(16 - begin), at(32 - end)), _mm_set1_epi8(amount));
  }
  /// Whether any cell would change; nothing is written yet, since a write may copy the tile.
  bool changes(const std::int8_t* cells) const {
    const __m128i before = _mm_load_si128(reinterpret_cast<const __m128i*>(cells));
    const __m128i after = _mm_adds_epi8(before, add_);
    return _mm_movemask_epi8(_mm_cmpeq_epi8(before, after)) != 0xFFFF;
  }
  /// Adds. Bit i of the result: cell i went from occupied to not occupied.
  unsigned apply(std::int8_t* cells) const {
    __m128i* p = reinterpret_cast<__m128i*>(cells);
    const __m128i before = _mm_load_si128(p);
    const __m128i after = _mm_adds_epi8(before, add_);
    _mm_store_si128(p, after);
    return static_cast<unsigned>(_mm_movemask_epi8(_mm_andnot_si128(after, before)));
  }

 private:
  __m128i add_;
};

#else

inline bool allMostFree(const std::int8_t* cells) {
  bool all = true;
  for (int i = 0; i < kLanes; ++i) all &= cells[i] == kMostFree;
  return all;
}

class FillLanes {
 public:
  FillLanes(int begin, int end, std::int8_t amount) : begin_(begin), end_(end), amount_(amount) {}
  bool changes(const std::int8_t* cells) const {
    for (int i = begin_; i < end_; ++i)
      if (added(cells[i]) != cells[i]) return true;
    return false;
  }
  unsigned apply(std::int8_t* cells) const {
    unsigned freed = 0;
    for (int i = begin_; i < end_; ++i) {
      if (cells[i] < 0 && added(cells[i]) >= 0) freed |= 1U << i;
      cells[i] = added(cells[i]);
    }
    return freed;
  }

 private:
  std::int8_t added(std::int8_t v) const {
    const int sum = v + amount_;
    return static_cast<std::int8_t>(sum > 127 ? 127 : sum);
  }
  int begin_;
  int end_;
  std::int8_t amount_;
};

#endif

}  // namespace ariadne::grid
