#include "ariadne/loops/search/piece.h"

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "ariadne/geometry/pose.h"
#include "ariadne/grid/field/endpoint_likelihood.h"

namespace ariadne::loops {

std::vector<mrpt::math::TPoint2D> lastPiece(const Track& track, const std::vector<ScanHits>& hits,
                                            double length_m, double spacing_m, std::size_t most) {
  const std::size_t now = track.now();
  std::set<std::pair<std::int64_t, std::int64_t>> taken;
  std::vector<mrpt::math::TPoint2D> piece;
  for (std::size_t k = now + 1; k-- > 0;) {
    if (track.travelled_m[now] - track.travelled_m[k] > length_m) break;
    const auto now_from_then = geometry::relativePose(track.poses[now], track.poses[k]);
    for (const auto& p : geometry::placed(now_from_then, hits[k])) {
      const auto i = static_cast<std::int64_t>(std::floor(p.x / spacing_m));
      const auto j = static_cast<std::int64_t>(std::floor(p.y / spacing_m));
      if (taken.emplace(i, j).second) piece.push_back(p);
    }
  }
  return grid::thinned(piece, most);
}

}  // namespace ariadne::loops
