#include "payload.h"

namespace ariadne::io::ros {

using eprosima::fastcdr::Cdr;

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
      cdr_(buffer_, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR) {
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

std::size_t CdrPayload::left() const { return bytes_.size() - cdr_.getSerializedDataLength(); }

}  // namespace ariadne::io::ros
