// ROS 1 recordings (.bag, version 2.0). http://wiki.ros.org/Bags/Format/2.0
#pragma once
#include <map>
#include <memory>

#include "bytes.h"

namespace ariadne::io::ros {

/// What the header of a record says; fields that are not there stay as they are here.
struct Ros1Record {
  int op = -1;
  std::uint32_t connection = 0;
  std::int64_t time_ns = 0;
  std::uint64_t index_at = 0;
  std::uint32_t unpacked_size = 0;
  std::string topic, compression, encryptor;
  std::uint32_t data_size = 0;  ///< of what follows the header
};

/// Read from front to back and without the index at the end, which a recorder that was stopped
/// hard has not written. A chunk without compression is walked in place.
class Ros1Bag : public BagReader {
 public:
  /// Throws core::Error when it cannot be opened, BagDamage when it is of another version.
  explicit Ros1Bag(const std::filesystem::path& path);

  std::optional<BagMessage> next() override;
  std::string_view payload() override;
  double fraction() const override { return file_.fraction(); }
  std::string place() const override;
  std::string remark() const override { return remark_; }

 private:
  Bytes& source() { return chunk_ ? static_cast<Bytes&>(*chunk_) : file_; }
  void readFileHeader();
  void openChunk(const Ros1Record& record);
  void readConnection(const Ros1Record& record);

  FileBytes file_;
  std::unique_ptr<MemoryBytes> chunk_;  ///< unpacked, while one is read
  std::uint64_t chunk_at_ = 0;
  std::uint64_t record_at_ = 0;
  std::map<std::uint32_t, BagTopic> connections_;
  std::uint32_t payload_left_ = 0;
  std::string remark_;
};

}  // namespace ariadne::io::ros
