#include "log_updates.h"

#include <mrpt/core/bits_math.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ariadne::compare_app {

LogUpdates::LogUpdates(const slam_app::SlamConfig& config) {
  const auto source = io::openDataset(config.dataset.file, slam_app::optionsOf(config.dataset));
  const slam::UpdateParams& when = config.slam.update;
  std::optional<mrpt::math::TPose2D> last;
  while (const auto step = source->next()) {
    const mrpt::math::TPose2D& at = step->odom_from_robot;
    if (last && std::hypot(at.x - last->x, at.y - last->y) < when.update_distance_m &&
        std::abs(mrpt::math::wrapToPi(at.phi - last->phi)) < mrpt::DEG2RAD(when.update_angle_deg))
      continue;
    last = at;
    shares_.push_back(source->fraction());
  }
}

double LogUpdates::shareOfUpdates(double share_of_log) const {
  const auto later = std::upper_bound(shares_.begin(), shares_.end(), share_of_log);
  return static_cast<double>(later - shares_.begin()) /
         static_cast<double>(std::max<std::size_t>(shares_.size(), 1));
}

}  // namespace ariadne::compare_app
