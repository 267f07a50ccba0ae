// What of a ROS recording is used, where it holds more than one of a thing.
#pragma once
#include <optional>
#include <string>

namespace ariadne::io {

/// Where a planar laser is on the robot: m, degrees, in the robot's frame.
struct LaserPose {
  double x_m = 0, y_m = 0;
  double yaw_deg = 0;
  bool upside_down = false;
};

/// Empty: the only one.
struct RosOptions {
  std::string scan_topic;  ///< of sensor_msgs/LaserScan
  std::string odom_topic;  ///< of nav_msgs/Odometry or, as transforms, tf2_msgs/TFMessage
  std::string odom_frame;  ///< of transforms: the frame that odometry starts in
  std::string base_frame;  ///< the robot's: what the odometry moves, and the laser is fixed to
  std::optional<LaserPose> laser_pose;  ///< instead of what the recording says

  /// Whether anything is set.
  bool any() const {
    return laser_pose || !(scan_topic + odom_topic + odom_frame + base_frame).empty();
  }
};

/// "0.2 0 -90" (m, m, degrees) with "upside_down" behind it or not; empty is nullopt. Throws
/// core::UsageError naming `where`.
std::optional<LaserPose> parseLaserPose(const std::string& text, const std::string& where);

}  // namespace ariadne::io
