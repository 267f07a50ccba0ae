// The YAML of a ROS map (map_server of ROS 1, nav2_map_server), which names a picture and says how
// it is meant: http://wiki.ros.org/map_server#YAML_format
#pragma once
#include <mrpt/math/TPose2D.h>

#include <filesystem>
#include <optional>

namespace ariadne::io {

/// What a map.yaml of ROS map_server or nav2 says.
struct RosMapFile {
  /// How the picture's grey is to be understood.
  enum class Mode {
    trinary,  ///< free, occupied or unknown
    scale,    ///< and probabilities between them
    raw,      ///< a pixel's value is the probability in percent; over 100 is unknown
  };
  std::filesystem::path picture;
  Mode mode = Mode::trinary;
  double resolution_m = 0;               ///< side of a pixel
  mrpt::math::TPose2D map_from_picture;  ///< m, rad: of the lower left corner of the picture
  bool negate = false;                   ///< white is occupied
  double occupied_thresh = 0;            ///< probability over which a pixel is occupied
  double free_thresh = 0;                ///< under which it is free
};

/// Keys as both servers take them: all but mode must be there. Throws core::Error naming file,
/// line, key and what would be right.
RosMapFile readRosMapFile(const std::filesystem::path& yaml);

/// The picture that a YAML names, when it is one that names a file that exists; nothing for any
/// other file. A relative path starts at the YAML's folder.
std::optional<std::filesystem::path> pictureOfRosMap(const std::filesystem::path& yaml);

}  // namespace ariadne::io
