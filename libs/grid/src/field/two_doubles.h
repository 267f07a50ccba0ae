// Two doubles at a time, in GCC's and Clang's vector types, so that every processor has them; to
// the same bits as one by one.
#pragma once
#include <cstdint>

namespace ariadne::grid {

using TwoDoubles = double __attribute__((vector_size(16), aligned(8), may_alias));
using TwoInts = std::int64_t __attribute__((vector_size(16), aligned(8), may_alias));

inline TwoDoubles& twoAt(double* p) { return *reinterpret_cast<TwoDoubles*>(p); }
inline const TwoDoubles& twoAt(const double* p) { return *reinterpret_cast<const TwoDoubles*>(p); }

/// The nearest whole numbers, |v| under 2^31, also as ints in the low halves of `ints`.
inline TwoDoubles rounded(TwoDoubles v, TwoInts& ints) {
  // 1.5 * 2^52: what is added to it is rounded to whole numbers, and stands in the low bits.
  constexpr TwoDoubles kRounder = {6755399441055744.0, 6755399441055744.0};
  const TwoDoubles sum = v + kRounder;
  ints = reinterpret_cast<const TwoInts&>(sum);
  return sum - kRounder;
}

}  // namespace ariadne::grid
