// A recording as a stream of serialized messages, whatever the file they stand in.
#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ariadne::io::ros {

/// The file is not what its format says; the message is the reason.
struct BagDamage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct BagTopic {
  std::string name;
  std::string type;      ///< as the file has it: sensor_msgs/LaserScan, sensor_msgs/msg/LaserScan
  std::string encoding;  ///< of the payload: "ros1", "cdr" or another that is not read here
};

struct BagMessage {
  const BagTopic* topic = nullptr;  ///< lives as long as the reader
  std::int64_t time_ns = 0;         ///< when it was recorded
};

/// Messages in the order of the file. Memory is bounded by what the file truly holds.
class BagReader {
 public:
  virtual ~BagReader() = default;
  /// The next message; nullopt at the end of the file. Throws BagDamage where the file is broken,
  /// and must not be called after that.
  virtual std::optional<BagMessage> next() = 0;
  /// The bytes of the message that next() gave, valid until the next call. Throws BagDamage.
  virtual std::string_view payload() = 0;
  /// How much of the file was read, 0 to 1.
  virtual double fraction() const = 0;
  /// Where in the file the reader is, for messages about damage: "byte 123".
  virtual std::string place() const = 0;
  /// What is odd about the file but no damage; empty for none. Complete at the end.
  virtual std::string remark() const { return ""; }
};

}  // namespace ariadne::io::ros
