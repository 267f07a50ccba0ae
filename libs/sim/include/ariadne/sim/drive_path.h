// Scripted drives: waypoints that a simulated robot is to pass, one command a line, `#` comments:
//
//   laps 3           what `repeat laps` means unless the caller says otherwise
//   goto x y         a waypoint, metres, frame of the world
//   repeat N ... end       the lines between N times; may be nested; 0 skips them
//   repeat laps ... end    the same with the number of laps
//   mark NAME        the time is kept at which the robot is done with all that stands above
#pragma once
#include <mrpt/math/TPoint2D.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::sim {

/// A point of a scripted drive.
struct Waypoint {
  mrpt::math::TPoint2D at;  ///< m, frame of the world
  int line = 0;             ///< of the file, for errors
};

/// A place in a drive, named; the same name comes again where it stands in a repeated block.
struct Mark {
  std::string name;
  std::size_t after = 0;  ///< so many waypoints are behind the robot
};

/// A scripted drive through a world, as its .path file says.
struct DrivePath {
  std::string name;  ///< what errors call it: the file
  std::vector<Waypoint> waypoints;
  std::vector<Mark> marks;      ///< in order
  bool has_laps_block = false;  ///< the number of laps makes a difference
  int laps = 0;                 ///< the number used
};

/// @param laps overrides the file's line `laps`
/// Throws core::Error naming file and line and saying what would be right: an unknown command, a
/// wrong count of words, a bad number, an `end` or a `repeat` without its partner, laps that nobody
/// set, no waypoint, over 1e6 waypoints and marks. Throws core::UsageError for laps under 0 or over
/// 1e6.
DrivePath parsePath(std::string_view text, const std::string& name, std::optional<int> laps = {});

/// The same for a file; also throws when it cannot be read.
DrivePath readPath(const std::filesystem::path& path, std::optional<int> laps = {});

}  // namespace ariadne::sim
