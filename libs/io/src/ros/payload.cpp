#include "payload.h"

namespace ariadne::io::ros {

using eprosima::fastcdr::Cdr;

namespace {
#if __has_include(<fastcdr/CdrEncoding.hpp>)  // Fast CDR 2, of Debian 13
constexpr auto kFormOfCdr = eprosima::fastcdr::CdrVersion::DDS_CDR;
std::size_t bytesRead(const Cdr& cdr) { return cdr.get_serialized_data_length(); }
#else
constexpr auto kFormOfCdr = Cdr::DDS_CDR;
std::size_t bytesRead(const Cdr& cdr) { return cdr.getSerializedDataLength(); }
#endif
}  // namespace

std::string_view Ros1Payload::take(std::uint64_t count) {
  if (count > bytes_.size()) throw BagDamage("the message ends early");
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return taken;
}

CdrPayload::CdrPayload(std::string_view bytes)
    : bytes_(bytes),
      // Only read from: the interface wants no const.
      buffer_(const_cast<char*>(bytes.data()), bytes.size()),
      cdr_(buffer_, Cdr::DEFAULT_ENDIAN, kFormOfCdr) {
  guarded([&] { cdr_.read_encapsulation(); });
}

std::string CdrPayload::text() {
  std::string value;
  guarded([&] { cdr_.deserialize(value); });
  return value;
}

void CdrPayload::skipFloats() {
  const std::uint64_t size = std::uint64_t{count()} * sizeof(float);
  if (size > left() || !cdr_.jump(size)) throw BagDamage("the message ends early");
}

void CdrPayload::skipDoubles(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) number<double>();
}

std::size_t CdrPayload::left() const { return bytes_.size() - bytesRead(cdr_); }

}  // namespace ariadne::io::ros
