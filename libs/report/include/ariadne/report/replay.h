// What report.html shows of a run: a plain description, made by ReplayRecorder while the run goes
// on, written by writeReport(). Everything is in the map frame, m and rad, unless it says
// otherwise.
#pragma once
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ariadne/loops/closing/loop_watcher.h"

namespace ariadne::report {

/// Side of a tile of the drawn map, pixels.
constexpr int kReplayTile = 32;
/// What a pixel shows; of several cells the most occupied counts, else free, else unknown.
enum class MapPixel : std::uint8_t { unknown, free, occupied };
/// Pixels of a tile, two bits each, the first in the highest bits; row by row from the south.
using ReplayTile = std::array<std::uint8_t, kReplayTile * kReplayTile / 4>;

/// Where a tile lies, in tiles from the map's origin, and which it is of Replay::tiles.
struct PlacedTile {
  int x = 0;
  int y = 0;
  std::uint32_t tile = 0;
};

/// A particle as the replay draws it.
struct ReplayParticle {
  mrpt::math::TPose2D map_from_robot;
  double weight = 0;  ///< normalised over the whole set
};

/// G of s*; edges are indices of places.
struct ReplayGraph {
  std::vector<mrpt::math::TPoint2Df> places;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
};

/// A loop opportunity that fired: the entry point x_te and where the robot was.
struct ReplayShortcut {
  mrpt::math::TPoint2D entry;
  mrpt::math::TPoint2D robot;
};

/// What only the caller knows and wants drawn; whatever is empty is not.
struct ReplayScene {
  std::vector<std::vector<mrpt::math::TPoint2D>> frontiers;  ///< points of each cluster
  std::optional<ReplayShortcut> shortcut;
  std::vector<mrpt::math::TPoint2D> plan;  ///< planned path, a polyline
  std::optional<mrpt::math::TPoint2D> goal;
};

/// The particles after one filter update.
struct ReplayCloud {
  std::size_t step = 0;  ///< index of Replay::steps
  std::vector<ReplayParticle> particles;
};

/// A keyframe: what else is drawn after one filter update.
struct ReplayFrame {
  std::size_t step = 0;                     ///< index of Replay::steps
  bool pinned = false;                      ///< thinned out only when nothing else is left
  std::vector<PlacedTile> map;              ///< of s*; row by row from the south
  std::vector<mrpt::math::TPoint2Df> path;  ///< of s*, from the start, thinned
  ReplayGraph graph;
  ReplayScene scene;
};

/// A filter update.
struct ReplayStep {
  double time_s = 0;      ///< UNIX time
  double distance_m = 0;  ///< travelled since the first update
  double neff = 0;        ///< Eq. (10), before resampling
  bool resampled = false;
  std::optional<std::size_t> unique_ancestors;  ///< as slam::StepReport counts them
  double pose_entropy = 0;                   ///< nats, eval::gaussianEntropy: first term of Eq. (6)
  std::optional<double> map_entropy;         ///< nats, known cells of s*: second term; at keyframes
  std::optional<double> error_m;             ///< distance of s* from the true position
  mrpt::math::TPose2D map_from_robot;        ///< s* as believed then
  std::optional<mrpt::math::TPose2D> truth;  ///< true map_from_robot
  loops::LoopState loop_state = loops::LoopState::exploring;
  std::string state;  ///< in words
};

/// What happened then.
enum class MomentKind { decision, detection, entry, end, recovery };

/// Something to jump to.
struct ReplayMoment {
  std::size_t step = 0;  ///< index of Replay::steps
  MomentKind kind = MomentKind::decision;
  std::string title;
  std::string text;
  std::vector<std::vector<std::string>> table;  ///< rows, the first one heads; may be empty
};

/// A line about the run: "Particles", "30".
struct ReplayFact {
  std::string name;
  std::string value;
};

/// A run to be replayed: what report.html shows.
struct Replay {
  std::string title;
  std::vector<ReplayFact> facts;   ///< of the run, for the page's head
  std::vector<std::string> notes;  ///< how figures were come by, for the page's foot
  std::size_t particles = 0;       ///< N
  std::vector<ReplayStep> steps;
  std::vector<ReplayMoment> moments;  ///< in any order
  std::vector<ReplayCloud> clouds;    ///< by step
  std::vector<ReplayFrame> frames;    ///< by step
  std::vector<ReplayTile> tiles;      ///< tile 0 is all unknown
  mrpt::math::TPoint2D map_origin;    ///< south west corner of tile (0, 0)
  double pixel_m = 1;                 ///< side of a pixel of the drawn map
};

}  // namespace ariadne::report
