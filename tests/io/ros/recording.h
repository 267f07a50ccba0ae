// Small recordings of odd content for tests: an MCAP without chunks, its messages serialized as
// ROS 1 does. What other libraries write is in datasets/ros.
#pragma once
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace recording {

/// Bytes of numbers and texts one after the other, little-endian.
class Packed {
 public:
  template <class T>
  Packed& add(T value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
    return *this;
  }
  Packed& text(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
    return *this;
  }
  Packed& raw(const std::string& bytes) {
    bytes_ += bytes;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

struct Stamp {
  std::uint32_t s = 0, ns = 0;
};

inline Packed header(const Stamp& stamp, const std::string& frame) {
  return Packed().add<std::uint32_t>(0).add(stamp.s).add(stamp.ns).text(frame);
}

struct Scan {
  Stamp stamp;
  std::string frame = "laser";
  float angle_min = -1, angle_max = 1, increment = 0.5;
  float range_min = 0.1F, range_max = 10;
  std::vector<float> ranges = {1, 2, 3, 4, 5};
  std::string bytes() const {
    Packed p = header(stamp, frame);
    for (const float f : {angle_min, angle_max, increment, 0.F, 0.F, range_min, range_max})
      p.add(f);
    p.add(static_cast<std::uint32_t>(ranges.size()));
    for (const float r : ranges) p.add(r);
    return p.add<std::uint32_t>(0).bytes();
  }
};

struct At {
  double x = 0, y = 0, z = 0;
  double qx = 0, qy = 0, qz = 0, qw = 1;
};
inline At turned(double x, double y, double yaw) {
  return {x, y, 0, 0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
}
inline void add(Packed& p, const At& at) {
  for (const double v : {at.x, at.y, at.z, at.qx, at.qy, at.qz, at.qw}) p.add(v);
}

inline std::string odometry(const Stamp& stamp, const At& at, const std::string& child = "base",
                            const std::string& frame = "odom") {
  Packed p = header(stamp, frame);
  p.text(child);
  add(p, at);
  return p.raw(std::string(78 * sizeof(double), '\0')).bytes();
}

struct Tf {
  std::string parent, child;
  At at;
};
inline std::string transforms(const Stamp& stamp, const std::vector<Tf>& list) {
  Packed p;
  p.add(static_cast<std::uint32_t>(list.size()));
  for (const Tf& tf : list) {
    p.raw(header(stamp, tf.parent).text(tf.child).bytes());
    add(p, tf.at);
  }
  return p.bytes();
}

class Mcap {
 public:
  Mcap() { record(1, Packed().text("ros1").text("")); }
  Mcap& message(const std::string& topic, const std::string& type, const std::string& payload,
                const Stamp& recorded, const std::string& encoding = "ros1") {
    const auto [found, is_new] = channels_.try_emplace(topic, channels_.size() + 1);
    if (is_new) {
      record(3, Packed().add(found->second).text(type).text("ros1msg").text(""));
      record(4, Packed().add(found->second).add(found->second).text(topic).text(encoding).text(""));
    }
    const std::uint64_t time_ns = recorded.s * 1'000'000'000ULL + recorded.ns;
    record(
        5,
        Packed().add(found->second).add<std::uint32_t>(0).add(time_ns).add(time_ns).raw(payload));
    return *this;
  }
  Mcap& scan(const Scan& s, const std::string& topic = "/scan") {
    return message(topic, "sensor_msgs/LaserScan", s.bytes(), s.stamp);
  }
  Mcap& odom(const Stamp& stamp, const At& at, const std::string& child = "base",
             const std::string& topic = "/odom") {
    return message(topic, "nav_msgs/Odometry", odometry(stamp, at, child), stamp);
  }
  Mcap& tf(const Stamp& stamp, const std::vector<Tf>& list, const std::string& topic = "/tf") {
    return message(topic, "tf2_msgs/TFMessage", transforms(stamp, list), stamp);
  }
  Mcap& fixed(const std::vector<Tf>& list) { return tf({1000, 0}, list, "/tf_static"); }
  Mcap& record(unsigned char op, const Packed& content) {
    body_.add(op).add<std::uint64_t>(content.bytes().size()).raw(content.bytes());
    return *this;
  }
  /// The whole file; without the end it is one that was not closed.
  std::string bytes(bool closed = true) const {
    std::string all = magic() + body_.bytes();
    if (!closed) return all;
    const auto end = Packed().add<unsigned char>(15).add<std::uint64_t>(4).add<std::uint32_t>(0);
    const auto footer =
        Packed().add<unsigned char>(2).add<std::uint64_t>(20).raw(std::string(20, '\0'));
    return all + end.bytes() + footer.bytes() + magic();
  }

 private:
  static std::string magic() { return {"\x89MCAP0\r\n", 8}; }
  Packed body_;
  std::map<std::string, std::uint16_t> channels_;
};

/// A drive of four scans 0.5 m apart, a second each, with odometry at the same times.
inline Mcap drive(const std::vector<std::string>& lasers = {"laser"}) {
  Mcap file;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Stamp stamp{1000 + i, 0};
    file.odom(stamp, turned(0.5 * i, 0, 0));
    for (const std::string& frame : lasers) {
      Scan scan;
      scan.stamp = stamp;
      scan.frame = frame;
      file.scan(scan, lasers.size() == 1 ? "/scan" : "/" + frame + "/scan");
    }
  }
  return file;
}

}  // namespace recording
