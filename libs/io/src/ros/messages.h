// The messages that a map is made of, from either serialization.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bag_reader.h"

namespace ariadne::io::ros {

/// What a message is to us.
enum class MessageKind { other, laser_scan, odometry, transforms, point_cloud };
/// By the name of the type, in ROS 1's form or in ROS 2's.
MessageKind kindOf(std::string_view type);

struct Header {
  std::optional<std::int64_t> stamp_ns;  ///< nullopt where it is 0
  std::string frame;                     ///< without a leading slash
};

/// sensor_msgs/LaserScan: rad and m.
struct LaserScan {
  Header header;
  float angle_min = 0, angle_max = 0, angle_increment = 0;
  float range_min = 0, range_max = 0;
  std::vector<float> ranges;
};

/// A pose or a transform, target_from_source; the quaternion is of length 1.
struct Pose {
  double x = 0, y = 0, z = 0;
  double qx = 0, qy = 0, qz = 0, qw = 1;
};

/// nav_msgs/Odometry.
struct Odometry {
  Header header;
  std::string child_frame;
  Pose pose;
};

/// geometry_msgs/TransformStamped: header.frame from child_frame.
struct Transform {
  Header header;
  std::string child_frame;
  Pose pose;
};

/// Each throws BagDamage when the payload is none of this type, or holds what cannot be: numbers
/// that are not finite, a quaternion without length, bytes left over.
LaserScan readLaserScan(const BagTopic& topic, std::string_view payload);
/// The frame of a LaserScan, without reading the rest.
Header readHeader(const BagTopic& topic, std::string_view payload);
Odometry readOdometry(const BagTopic& topic, std::string_view payload);
std::vector<Transform> readTransforms(const BagTopic& topic, std::string_view payload);

}  // namespace ariadne::io::ros
