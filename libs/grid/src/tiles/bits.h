// Bits of a word, without instructions that not every x86-64 has.
#pragma once
#include <cstdint>

namespace ariadne::grid {

inline int countBits(std::uint32_t w) {
  w -= w >> 1 & 0x55555555U;
  w = (w & 0x33333333U) + (w >> 2 & 0x33333333U);
  w = (w + (w >> 4)) & 0x0F0F0F0FU;
  return static_cast<int>(w * 0x01010101U >> 24);
}

/// Calls f(x) for each bit that is set, lowest first.
template <class F>
void forEachBit(std::uint32_t w, F&& f) {
  for (; w != 0; w &= w - 1) f(__builtin_ctz(w));
}

}  // namespace ariadne::grid
