#include "mcap_bag.h"

#include <fmt/format.h>
#include <zlib.h>

#include <utility>

#include "unpack.h"

namespace ariadne::io::ros {
namespace {

enum Op { kSchema = 3, kChannel = 4, kMessage = 5, kChunk = 6, kDataEnd = 15 };

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::uint32_t kLongestText = 1 << 16;
constexpr std::uint64_t kMessageHeader = 2 + 4 + 8 + 8;

}  // namespace

McapBag::McapBag(const std::filesystem::path& path) : file_(path) {
  if (file_.take(std::min<std::uint64_t>(kMagic.size(), file_.left())) != kMagic)
    throw BagDamage("an MCAP file of another version than 0");
}

std::string McapBag::place() const {
  return chunk_ ? fmt::format("the chunk at byte {}", chunk_at_)
                : fmt::format("byte {}", record_at_);
}

std::string McapBag::text() {
  Bytes& in = source();
  const auto size = in.number<std::uint32_t>();
  if (size > kLongestText) throw BagDamage(fmt::format("a text claims {} bytes", size));
  return std::string(in.take(size));
}

bool McapBag::atEnd() {
  if (chunk_ && chunk_->left() == 0) chunk_.reset();
  if (source().left() > 0) return ended_;
  remark_ = "the file was not closed by its recorder: it is read up to where it ends";
  return ended_ = true;
}

std::optional<BagMessage> McapBag::next() {
  source().skip(std::exchange(payload_left_, 0));
  while (!atEnd()) {
    Bytes& in = source();
    record_at_ = in.offset();
    const int op = in.number<std::uint8_t>();
    const auto size = in.number<std::uint64_t>();
    if (size > in.left()) in.skip(size);  // says what is missing
    if (op == kMessage) {
      if (size < kMessageHeader) throw BagDamage(fmt::format("a message of {} bytes", size));
      const auto id = in.number<std::uint16_t>();
      in.skip(4);
      const auto time_ns = in.number<std::uint64_t>();
      in.skip(8);
      const auto found = channels_.find(id);
      if (found == channels_.end())
        throw BagDamage(fmt::format("a message of channel {}, which is nowhere described", id));
      payload_left_ = size - kMessageHeader;
      return BagMessage{&found->second, static_cast<std::int64_t>(time_ns)};
    }
    if (op == kChunk && !chunk_) {
      openChunk(size);
    } else if (op == kSchema) {
      readSchema(size);
    } else if (op == kChannel) {
      readChannel(size);
    } else if (op == kDataEnd && !chunk_) {
      ended_ = true;
    } else if (op == 0) {
      throw BagDamage("a record of kind 0");
    } else {
      in.skip(size);
    }
  }
  return std::nullopt;
}

std::string_view McapBag::payload() { return source().take(std::exchange(payload_left_, 0)); }

void McapBag::openChunk(std::uint64_t size) {
  const std::uint64_t begin = file_.offset();
  file_.skip(16);  // first and last time
  const auto unpacked_size = file_.number<std::uint64_t>();
  const auto checksum = file_.number<std::uint32_t>();
  const std::string name = text();
  const auto packed_size = file_.number<std::uint64_t>();
  if (file_.offset() - begin + packed_size != size)
    throw BagDamage(fmt::format("a chunk of {} bytes with {} bytes of records", size, packed_size));
  const auto codec = codecOf(name);
  if (!codec)
    throw BagDamage(fmt::format("a chunk compressed with {}; none, lz4 and zstd are read", name));
  if (*codec == Codec::none && checksum == 0) return;  // walked in place
  chunk_at_ = record_at_;
  std::vector<char> bytes = unpack(*codec, file_.take(packed_size), unpacked_size);
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (checksum != 0 && sum != checksum) throw BagDamage("a chunk's checksum is wrong");
  chunk_ = std::make_unique<MemoryBytes>(std::move(bytes));
}

void McapBag::readSchema(std::uint64_t size) {
  Bytes& in = source();
  const std::uint64_t begin = in.offset();
  const auto id = in.number<std::uint16_t>();
  schemas_[id] = text();
  if (in.offset() - begin > size) throw BagDamage("a schema is longer than its record");
  in.skip(size - (in.offset() - begin));
}

void McapBag::readChannel(std::uint64_t size) {
  Bytes& in = source();
  const std::uint64_t begin = in.offset();
  const auto id = in.number<std::uint16_t>();
  const auto schema = in.number<std::uint16_t>();
  BagTopic topic;
  topic.name = text();
  topic.encoding = text();
  const auto found = schemas_.find(schema);
  if (found != schemas_.end()) topic.type = found->second;
  channels_.emplace(id, std::move(topic));
  if (in.offset() - begin > size) throw BagDamage("a channel is longer than its record");
  in.skip(size - (in.offset() - begin));
}

}  // namespace ariadne::io::ros
