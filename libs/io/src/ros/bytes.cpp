#include "bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "ariadne/core/error.h"

namespace ariadne::io::ros {
namespace {

// Small enough that pictures between the scans are jumped over unread.
constexpr std::size_t kWindow = 1 << 17;

}  // namespace

std::uint64_t sizeOf(const std::filesystem::path& path) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code) throw core::Error(fmt::format("cannot read {}: {}", path.string(), code.message()));
  return size;
}

void Bytes::requireLeft(std::uint64_t count) const {
  if (count > left())
    throw BagDamage(fmt::format("{} bytes should follow, but there are only {}", count, left()));
}

FileBytes::FileBytes(const std::filesystem::path& path)
    : Bytes(sizeOf(path)), file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (file_ < 0)
    throw core::Error(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
}

FileBytes::~FileBytes() { ::close(file_); }

std::string_view FileBytes::view(std::uint64_t from, std::size_t count) {
  const bool inside = from >= window_begin_ && from + count <= window_begin_ + window_size_;
  if (!inside) {
    window_begin_ = from;
    window_size_ = 0;
    // Grown at most to what the file has: `count` was checked against its size.
    if (window_.size() < count || window_.size() < kWindow)
      window_.resize(std::max(count, kWindow));
    while (window_size_ < count) {
      const auto got = ::pread(file_, window_.data() + window_size_, window_.size() - window_size_,
                               static_cast<off_t>(from + window_size_));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw BagDamage(std::strerror(errno));
      if (got == 0) throw BagDamage("the file became shorter while it was read");
      window_size_ += static_cast<std::size_t>(got);
    }
  }
  return {window_.data() + (from - window_begin_), count};
}

}  // namespace ariadne::io::ros
