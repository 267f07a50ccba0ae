#include "ros1_bag.h"

#include <fmt/format.h>

#include <utility>

#include "ros1_record.h"
#include "unpack.h"

namespace ariadne::io::ros {
namespace {

enum Ros1Op {
  kRos1Message = 2,
  kRos1FileHeader = 3,
  kRos1Index = 4,
  kRos1Chunk = 5,
  kRos1ChunkInfo = 6,
  kRos1Connection = 7
};

constexpr std::string_view kRos1Magic = "#ROSBAG V2.0\n";
constexpr std::uint32_t kLongestConnection = 1 << 24;
constexpr std::size_t kMostConnections = 100'000;

}  // namespace

Ros1Bag::Ros1Bag(const std::filesystem::path& path) : file_(path) { readFileHeader(); }

void Ros1Bag::readFileHeader() {
  if (file_.take(std::min<std::uint64_t>(kRos1Magic.size(), file_.left())) != kRos1Magic)
    throw BagDamage("a bag of a version before 2.0: renew it with 'rosbag fix'");
  const Ros1Record header = readRos1Record(file_);
  if (header.op != kRos1FileHeader) throw BagDamage("a bag whose first record is not its header");
  if (!header.encryptor.empty())
    throw BagDamage(fmt::format("the bag is encrypted ({}): decrypt it with 'rosbag decrypt'",
                                header.encryptor));
  if (header.index_at == 0)
    remark_ = "the bag was not closed by its recorder: it is read up to where it ends";
  file_.skip(header.data_size);
}

std::string Ros1Bag::place() const {
  return chunk_ ? fmt::format("the chunk at byte {}", chunk_at_)
                : fmt::format("byte {}", record_at_);
}

std::optional<BagMessage> Ros1Bag::next() {
  source().skip(std::exchange(payload_left_, 0));
  for (;;) {
    Bytes& in = source();
    if (in.left() == 0) {
      if (!chunk_) return std::nullopt;
      chunk_.reset();
      continue;
    }
    record_at_ = in.offset();
    const Ros1Record record = readRos1Record(in);
    if (record.op == kRos1Message) {
      const auto found = connections_.find(record.connection);
      if (found == connections_.end())
        throw BagDamage(fmt::format("a message of connection {}, which is nowhere described",
                                    record.connection));
      if (record.data_size > in.left()) in.skip(record.data_size);  // says what is missing
      payload_left_ = record.data_size;
      return BagMessage{&found->second, record.time_ns};
    }
    if (record.op == kRos1Chunk && !chunk_) {
      openChunk(record);
    } else if (record.op == kRos1Connection) {
      readConnection(record);
    } else if (record.op == kRos1Index || record.op == kRos1ChunkInfo) {
      in.skip(record.data_size);
    } else {
      throw BagDamage(fmt::format("a record of kind {}", record.op));
    }
  }
}

std::string_view Ros1Bag::payload() { return source().take(std::exchange(payload_left_, 0)); }

void Ros1Bag::openChunk(const Ros1Record& record) {
  const auto codec = codecOf(record.compression);
  if (!codec)
    throw BagDamage(
        fmt::format("a chunk compressed with {}; none, bz2 and lz4 are read", record.compression));
  if (*codec == Codec::none) return;
  chunk_at_ = record_at_;
  chunk_ = std::make_unique<MemoryBytes>(
      unpack(*codec, file_.take(record.data_size), record.unpacked_size));
}

void Ros1Bag::readConnection(const Ros1Record& record) {
  if (record.data_size > kLongestConnection)
    throw BagDamage(fmt::format("a connection's description claims {} bytes", record.data_size));
  if (connections_.size() >= kMostConnections) throw BagDamage("over 100000 connections");
  BagTopic topic{record.topic, "", "ros1"};
  forEachRos1Field(source().take(record.data_size),
                   [&](std::string_view name, std::string_view value) {
                     if (name == "type") topic.type = value;
                   });
  connections_.emplace(record.connection, std::move(topic));
}

}  // namespace ariadne::io::ros
