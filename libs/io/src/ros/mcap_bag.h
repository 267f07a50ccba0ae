// MCAP recordings of ROS 2 or ROS 1. https://mcap.dev/spec
#pragma once
#include <map>
#include <memory>

#include "bytes.h"

namespace ariadne::io::ros {

/// Read from front to back and without the summary at the end. What a chunk holds is given out
/// after its checksum was found right.
class McapBag : public BagReader {
 public:
  /// Throws core::Error when it cannot be opened.
  explicit McapBag(const std::filesystem::path& path);

  std::optional<BagMessage> next() override;
  std::string_view payload() override;
  double fraction() const override { return ended_ ? 1 : file_.fraction(); }
  std::string place() const override;
  std::string remark() const override { return remark_; }

 private:
  Bytes& source() { return chunk_ ? static_cast<Bytes&>(*chunk_) : file_; }
  bool atEnd();
  void openChunk(std::uint64_t size);
  void readSchema(std::uint64_t size);
  void readChannel(std::uint64_t size);
  std::string text();

  FileBytes file_;
  std::unique_ptr<MemoryBytes> chunk_;  ///< unpacked, while one is read
  std::uint64_t chunk_at_ = 0;
  std::uint64_t record_at_ = 0;
  std::map<std::uint16_t, std::string> schemas_;  ///< name of the message type
  std::map<std::uint16_t, BagTopic> channels_;
  std::uint64_t payload_left_ = 0;
  bool ended_ = false;
  std::string remark_;
};

}  // namespace ariadne::io::ros
