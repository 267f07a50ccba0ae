#include "rawlog_by_mrpt.h"

#include <mrpt/serialization/CArchive.h>

#include <cstring>
#include <optional>
#include <stdexcept>

namespace ariadne::io {
namespace {

/// An object's header, then its body; a byte more than there is is an error.
class BoundedArchive : public mrpt::serialization::CArchive {
 public:
  /// Numbers above the body's size are read as `instead`, if it is given.
  BoundedArchive(const ObjectHeader& header, std::string_view body,
                 std::optional<std::uint64_t> instead)
      : head_(1, static_cast<char>(0x80 | header.name.size())), body_(body), instead_(instead) {
    head_ += header.name;
    head_ += static_cast<char>(header.version);
  }
  std::size_t used() const { return used_; }

 protected:
  std::size_t write(const void* /*bytes*/, std::size_t /*size*/) override { return 0; }
  std::size_t read(void* to, std::size_t size) override {
    if (head_used_ < head_.size()) {
      if (size > head_.size() - head_used_) throw std::runtime_error("header too short");
      std::memcpy(to, head_.data() + head_used_, size);
      head_used_ += size;
      return size;
    }
    if (size > body_.size() - used_) throw std::runtime_error("object too short");
    std::memcpy(to, body_.data() + used_, size);
    used_ += size;
    if (instead_ && (size == 4 || size == 8)) replaceLarge(to, size);
    return size;
  }

 private:
  void replaceLarge(void* number, std::size_t size) const {
    std::uint64_t value = 0;  // little-endian, as is every machine MRPT 2 runs on
    std::memcpy(&value, number, size);
    if (value > body_.size()) std::memcpy(number, &*instead_, size);
  }

  std::string head_;
  std::string_view body_;
  std::optional<std::uint64_t> instead_;
  std::size_t head_used_ = 0;
  std::size_t used_ = 0;
};

/// Takes what a class writes.
class WritingArchive : public mrpt::serialization::CArchive {
 public:
  const std::string& bytes() const { return bytes_; }

 protected:
  std::size_t write(const void* bytes, std::size_t size) override {
    bytes_.append(static_cast<const char*>(bytes), size);
    return size;
  }
  std::size_t read(void* /*to*/, std::size_t /*size*/) override { return 0; }

 private:
  std::string bytes_;
};

/// Bytes used; 0 when it cannot be read.
std::size_t tryReading(mrpt::serialization::CSerializable& out, const ObjectHeader& header,
                       std::string_view body, std::optional<std::uint64_t> instead) {
  BoundedArchive archive(header, body, instead);
  try {
    archive.ReadObject(&out);
  } catch (const std::exception&) {  // MRPT throws several kinds
    return 0;
  }
  return archive.used();
}

}  // namespace

int writtenVersion(const mrpt::serialization::CSerializable& object) {
  WritingArchive archive;
  archive << object;
  const std::string& bytes = archive.bytes();
  return static_cast<unsigned char>(bytes.at(1 + (static_cast<unsigned char>(bytes[0]) & 0x7FU)));
}

std::size_t readByMrpt(mrpt::serialization::CSerializable& out, const ObjectHeader& header,
                       std::string_view body) {
  if (header.old_format || header.version > writtenVersion(out)) return 0;
  const std::size_t size = tryReading(out, header, body, 0);
  if (size == 0 || size != tryReading(out, header, body, 1)) return 0;
  return tryReading(out, header, body, std::nullopt) == size ? size : 0;
}

}  // namespace ariadne::io
