// Bytes that are read from front to back, with jumps over what nobody wants to see.
#pragma once
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <vector>

#include "bag_reader.h"

namespace ariadne::io::ros {

/// Of a file, in bytes. Throws core::Error where it cannot be read.
std::uint64_t sizeOf(const std::filesystem::path& path);

class Bytes {
 public:
  virtual ~Bytes() = default;

  /// The next `count` bytes, which are then passed; valid until the next call. Throws BagDamage
  /// when there are fewer.
  std::string_view take(std::uint64_t count) {
    requireLeft(count);
    const std::string_view bytes = view(offset_, static_cast<std::size_t>(count));
    offset_ += count;
    return bytes;
  }
  /// A number as it lies in the file, little-endian as in all formats of ROS.
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  void skip(std::uint64_t count) {
    requireLeft(count);
    offset_ += count;
  }
  std::uint64_t offset() const { return offset_; }
  std::uint64_t left() const { return size_ - offset_; }
  double fraction() const {
    return size_ == 0 ? 1 : static_cast<double>(offset_) / static_cast<double>(size_);
  }

 protected:
  explicit Bytes(std::uint64_t size) : size_(size) {}
  virtual std::string_view view(std::uint64_t from, std::size_t count) = 0;

 private:
  void requireLeft(std::uint64_t count) const;

  std::uint64_t size_;
  std::uint64_t offset_ = 0;
};

/// A file, of which a window is in memory.
class FileBytes : public Bytes {
 public:
  /// Throws core::Error when it cannot be opened.
  explicit FileBytes(const std::filesystem::path& path);
  ~FileBytes() override;
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

 private:
  std::string_view view(std::uint64_t from, std::size_t count) override;

  int file_;
  std::vector<char> window_;
  std::uint64_t window_begin_ = 0;
  std::size_t window_size_ = 0;
};

class MemoryBytes : public Bytes {
 public:
  explicit MemoryBytes(std::vector<char> bytes) : Bytes(bytes.size()), bytes_(std::move(bytes)) {}

 private:
  std::string_view view(std::uint64_t from, std::size_t count) override {
    return {bytes_.data() + from, count};
  }
  std::vector<char> bytes_;
};

}  // namespace ariadne::io::ros
