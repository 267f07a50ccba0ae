#include "carmen_seam.h"

#include <algorithm>
#include <cmath>

#include "carmen_line.h"

namespace ariadne::io {
namespace {

// From one place a laser of 180 degrees may see the same to the left and to the right.
constexpr float kElsewhere_m = 0.1F;
constexpr std::size_t kFewest = 10;
constexpr double kAsNeighbours = 0.8;

bool isReading(float range) { return range > 0 && range < kCarmenMaxRange_m; }

bool areAlike(float a, float b) { return std::abs(a - b) < 0.03F + 0.02F * std::min(a, b); }

}  // namespace

void CarmenSeam::add(const std::vector<float>& ranges_m) {
  const std::size_t size = ranges_m.size();
  if (size < 3) return;
  const float first = ranges_m.front(), last = ranges_m.back();
  if (!isReading(first) || !isReading(last) || std::abs(first - counted_m_) < kElsewhere_m) return;
  counted_m_ = first;
  ++scans_;
  alike_ += areAlike(first, last) ? 1 : 0;
  for (std::size_t i = 1; i < size; ++i) {
    const float a = ranges_m[i - 1], b = ranges_m[i];
    if (!isReading(a) || !isReading(b)) continue;
    ++pairs_;
    alike_pairs_ += areAlike(a, b) ? 1 : 0;
  }
}

bool CarmenSeam::looksRound() const {
  return scans_ >= kFewest &&
         static_cast<double>(alike_) * static_cast<double>(pairs_) >=
             kAsNeighbours * static_cast<double>(alike_pairs_) * static_cast<double>(scans_);
}

}  // namespace ariadne::io
