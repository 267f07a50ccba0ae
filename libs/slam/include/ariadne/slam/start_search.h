// Where in a known map a log begins: its first metres are mapped for themselves, then laid over the
// known map as one piece.
#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <functional>
#include <optional>

#include "ariadne/models/sensor_step.h"
#include "ariadne/slam/params.h"

namespace ariadne::slam {

/// A pose of the log's first scan that its first metres fit.
struct StartPlace {
  mrpt::math::TPose2D map_from_robot;
  double field = 0;        ///< mean of the likelihood field under the ends of beams, 0 to 1
  double known_share = 0;  ///< of them lie where the map is known
};

/// Where in a known map a log begins.
struct StartSearch {
  /// Whether the first metres lie over what the map shows; a place that is hardly known to the map
  /// can be told by its user alone.
  enum class Result {
    found,      ///< best is the one
    unlike,     ///< they fit nowhere, or not about the pose that was given
    ambiguous,  ///< they fit rival about as well
    unmapped,   ///< about the pose that was given, the map is not known: best is that pose
  };
  Result result = Result::unlike;
  StartPlace best;
  std::optional<StartPlace> rival;  ///< of a search without a given pose
};

/// @param known scans with poses
/// @param next the log's steps from the first on; as many are taken as 10 m need
/// @param given where the robot is at the first scan, to 1 m and 15 degrees; nothing: it is
///   searched for over all free space of the known map
/// Throws core::Error when the steps hold no scan to go by.
StartSearch searchStart(const SlamParams& params, int threads, const mrpt::maps::CSimpleMap& known,
                        const std::function<std::optional<models::SensorStep>()>& next,
                        const std::optional<mrpt::math::TPose2D>& given);

}  // namespace ariadne::slam
