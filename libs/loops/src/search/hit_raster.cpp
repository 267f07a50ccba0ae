#include "ariadne/loops/search/hit_raster.h"

#include <cmath>

namespace ariadne::loops {

HitRaster::HitRaster(const mrpt::math::TPoint2D& centre, double half_m, double cell_m)
    : cell_m_(cell_m),
      size_(2 * static_cast<int>(std::ceil(half_m / cell_m)) + 1),
      low_(centre.x - 0.5 * size_ * cell_m, centre.y - 0.5 * size_ * cell_m),
      hits_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)) {}

int HitRaster::column(double x) const {
  return static_cast<int>(std::floor((x - low_.x) / cell_m_));
}
int HitRaster::row(double y) const { return static_cast<int>(std::floor((y - low_.y) / cell_m_)); }

void HitRaster::mark(const mrpt::math::TPoint2D& p) {
  const int i = column(p.x), j = row(p.y);
  if (i < 0 || j < 0 || i >= size_ || j >= size_) return;
  hits_[static_cast<std::size_t>(j) * static_cast<std::size_t>(size_) +
        static_cast<std::size_t>(i)] = 1;
}

std::size_t HitRaster::count(const std::vector<mrpt::math::TPoint2D>& points) const {
  std::size_t sum = 0;
  for (const auto& p : points) sum += static_cast<std::size_t>(at(column(p.x), row(p.y)));
  return sum;
}

}  // namespace ariadne::loops
