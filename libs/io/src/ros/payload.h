// The two ways in which ROS serializes a message, behind one set of calls. Both throw BagDamage
// when the bytes end early; no count that they claim is believed.
#pragma once
#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/NotEnoughMemoryException.h>

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "bag_reader.h"

namespace ariadne::io::ros {

/// ROS 1: packed, little-endian. http://wiki.ros.org/ROS/Technical%20Overview#Message_serialization
class Ros1Payload {
 public:
  static constexpr bool kHeaderHasSequence = true;

  explicit Ros1Payload(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::string text() { return std::string(take(number<std::uint32_t>())); }
  std::uint32_t count() { return number<std::uint32_t>(); }
  void floats(std::vector<float>& out) {
    const std::string_view bytes = take(std::uint64_t{count()} * sizeof(float));
    out.resize(bytes.size() / sizeof(float));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  }
  void skipFloats() { take(std::uint64_t{count()} * sizeof(float)); }
  void skipDoubles(std::size_t count) { take(count * sizeof(double)); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view take(std::uint64_t count);
  std::string_view bytes_;
};

/// ROS 2: CDR with its encapsulation header, in either byte order, by Fast CDR.
class CdrPayload {
 public:
  static constexpr bool kHeaderHasSequence = false;

  explicit CdrPayload(std::string_view bytes);
  template <class T>
  T number() {
    T value;
    guarded([&] { cdr_.deserialize(value); });
    return value;
  }
  std::string text();
  std::uint32_t count() { return number<std::uint32_t>(); }
  /// Fast CDR checks that a vector has at most as many elements as there are bytes.
  void floats(std::vector<float>& out) {
    guarded([&] { cdr_.deserialize(out); });
  }
  void skipFloats();
  void skipDoubles(std::size_t count);
  /// Bytes behind the last value; up to 3 may fill the message to a multiple of 4.
  std::size_t left() const;

 private:
  template <class Read>
  void guarded(Read read) {
    try {
      read();
    } catch (const eprosima::fastcdr::exception::NotEnoughMemoryException&) {
      throw BagDamage("the message ends early");
    } catch (const eprosima::fastcdr::exception::Exception&) {
      throw BagDamage("the message is in a form of CDR that Fast CDR does not know");
    }
  }
  std::string_view bytes_;
  eprosima::fastcdr::FastBuffer buffer_;
  eprosima::fastcdr::Cdr cdr_;
};

}  // namespace ariadne::io::ros
