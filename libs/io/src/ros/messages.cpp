#include "messages.h"

#include <fmt/format.h>

#include <cmath>
#include <type_traits>

#include "payload.h"
#include "unpack.h"

namespace ariadne::io::ros {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kMostBeams = 100'000;
constexpr std::size_t kLongestFrame = 1000;
constexpr std::size_t kMostUnpackedMessage = 1 << 26;
constexpr std::size_t kPadding = 3;

template <class In>
std::string readFrame(In& in) {
  std::string frame = in.text();
  // ROS 1's first tf wrote frames with a slash in front.
  if (!frame.empty() && frame[0] == '/') frame.erase(0, 1);
  if (frame.size() > kLongestFrame)
    throw BagDamage(fmt::format("the name of a frame has {} bytes", frame.size()));
  return frame;
}

template <class In>
Header readHeader(In& in) {
  if (In::kHeaderHasSequence) in.template number<std::uint32_t>();
  Header header;
  // ROS 1 has no sign here, ROS 2 one.
  using Seconds = std::conditional_t<In::kHeaderHasSequence, std::uint32_t, std::int32_t>;
  const std::int64_t seconds = in.template number<Seconds>();
  const std::int64_t stamp_ns = seconds * kSecond_ns + in.template number<std::uint32_t>();
  if (stamp_ns != 0) header.stamp_ns = stamp_ns;
  header.frame = readFrame(in);
  return header;
}

template <class In>
Pose readPose(In& in) {
  Pose p;
  for (double* value : {&p.x, &p.y, &p.z, &p.qx, &p.qy, &p.qz, &p.qw}) {
    *value = in.template number<double>();
    if (!std::isfinite(*value)) throw BagDamage("a pose is not finite");
  }
  const double length = std::sqrt(p.qx * p.qx + p.qy * p.qy + p.qz * p.qz + p.qw * p.qw);
  if (!(length > 1e-3 && length < 1e3))
    throw BagDamage(fmt::format("a quaternion of length {:g}", length));
  for (double* value : {&p.qx, &p.qy, &p.qz, &p.qw}) *value /= length;
  return p;
}

template <class In>
void requireEnd(const In& in) {
  if (in.left() > (In::kHeaderHasSequence ? 0U : kPadding))
    throw BagDamage(fmt::format("the message has {} bytes more than its type", in.left()));
}

template <class In>
void read(In& in, Header& header) {
  header = readHeader(in);
}

template <class In>
void read(In& in, LaserScan& scan) {
  scan.header = readHeader(in);
  scan.angle_min = in.template number<float>();
  scan.angle_max = in.template number<float>();
  scan.angle_increment = in.template number<float>();
  in.template number<float>();  // time from beam to beam
  in.template number<float>();  // time from scan to scan
  scan.range_min = in.template number<float>();
  scan.range_max = in.template number<float>();
  in.floats(scan.ranges);
  if (scan.ranges.size() > kMostBeams)
    throw BagDamage(fmt::format("a scan of {} beams", scan.ranges.size()));
  in.skipFloats();  // intensities
  requireEnd(in);
}

template <class In>
void read(In& in, Odometry& odometry) {
  odometry.header = readHeader(in);
  odometry.child_frame = readFrame(in);
  odometry.pose = readPose(in);
  in.skipDoubles(36 + 6 + 36);  // its covariance, the velocities, theirs
  requireEnd(in);
}

template <class In>
void read(In& in, std::vector<Transform>& transforms) {
  for (std::uint32_t left = in.count(); left > 0; --left) {
    Transform t;
    t.header = readHeader(in);
    t.child_frame = readFrame(in);
    t.pose = readPose(in);
    transforms.push_back(std::move(t));
  }
  requireEnd(in);
}

/// rosbag2 can compress each message for itself.
template <class Message>
Message decode(const BagTopic& topic, std::string_view payload) {
  Message message;
  if (topic.encoding == "ros1") {
    Ros1Payload in(payload);
    read(in, message);
    return message;
  }
  std::vector<char> unpacked;
  if (looksLikeZstd(payload)) {
    unpacked = unpackZstd(payload, kMostUnpackedMessage);
    payload = {unpacked.data(), unpacked.size()};
  }
  CdrPayload in(payload);
  read(in, message);
  return message;
}

}  // namespace

MessageKind kindOf(std::string_view type) {
  std::string plain(type);
  const std::size_t ros2 = plain.find("/msg/");
  if (ros2 != plain.npos) plain.erase(ros2, 4);
  if (plain == "sensor_msgs/LaserScan") return MessageKind::laser_scan;
  if (plain == "nav_msgs/Odometry") return MessageKind::odometry;
  if (plain == "tf2_msgs/TFMessage" || plain == "tf/tfMessage") return MessageKind::transforms;
  if (plain == "sensor_msgs/PointCloud2") return MessageKind::point_cloud;
  return MessageKind::other;
}

Header readHeader(const BagTopic& topic, std::string_view payload) {
  return decode<Header>(topic, payload);
}
LaserScan readLaserScan(const BagTopic& topic, std::string_view payload) {
  return decode<LaserScan>(topic, payload);
}
Odometry readOdometry(const BagTopic& topic, std::string_view payload) {
  return decode<Odometry>(topic, payload);
}
std::vector<Transform> readTransforms(const BagTopic& topic, std::string_view payload) {
  return decode<std::vector<Transform>>(topic, payload);
}

}  // namespace ariadne::io::ros
