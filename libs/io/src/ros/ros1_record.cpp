#include "ros1_record.h"

#include <fmt/format.h>

namespace ariadne::io::ros {
namespace {

constexpr std::uint32_t kLongestHeader = 1 << 16;
constexpr std::int64_t kSecondOfRecord_ns = 1'000'000'000;

template <class T>
T numberOf(std::string_view name, std::string_view value) {
  if (value.size() != sizeof(T))
    throw BagDamage(fmt::format("a record's {} has {} bytes", name, value.size()));
  T number;
  std::memcpy(&number, value.data(), sizeof(T));
  return number;
}

std::int64_t timeOf(std::string_view name, std::string_view value) {
  const auto both = numberOf<std::uint64_t>(name, value);
  return static_cast<std::int64_t>(both & 0xffffffff) * kSecondOfRecord_ns +
         static_cast<std::int64_t>(both >> 32);
}

}  // namespace

void forEachRos1Field(std::string_view header, const TakeField& take) {
  while (!header.empty()) {
    const auto size = numberOf<std::uint32_t>("field", header.substr(0, 4));
    header.remove_prefix(4);
    if (size > header.size()) throw BagDamage("a field is longer than its record's header");
    const std::string_view field = header.substr(0, size);
    const std::size_t equals = field.find('=');
    if (equals == field.npos) throw BagDamage("a field of a record has no name");
    take(field.substr(0, equals), field.substr(equals + 1));
    header.remove_prefix(size);
  }
}

Ros1Record readRos1Record(Bytes& in) {
  const auto size = in.number<std::uint32_t>();
  if (size > kLongestHeader)
    throw BagDamage(fmt::format("a record's header claims {} bytes", size));
  Ros1Record record;
  forEachRos1Field(in.take(size), [&](std::string_view name, std::string_view value) {
    if (name == "op") record.op = numberOf<std::uint8_t>(name, value);
    if (name == "conn") record.connection = numberOf<std::uint32_t>(name, value);
    if (name == "time") record.time_ns = timeOf(name, value);
    if (name == "index_pos") record.index_at = numberOf<std::uint64_t>(name, value);
    if (name == "size") record.unpacked_size = numberOf<std::uint32_t>(name, value);
    if (name == "topic") record.topic = value;
    if (name == "compression") record.compression = value;
    if (name == "encryptor") record.encryptor = value;
  });
  record.data_size = in.number<std::uint32_t>();
  return record;
}

}  // namespace ariadne::io::ros
