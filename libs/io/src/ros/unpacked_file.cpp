#include "unpacked_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "ariadne/core/error.h"
#include "bytes.h"

namespace ariadne::io::ros {
namespace {

constexpr std::uint64_t kMostGrowth = 1000;
constexpr std::uint64_t kPiece = 1 << 17;

void write(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const auto written = ::write(file, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw core::Error(std::strerror(errno));
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

}  // namespace

UnpackedFile::UnpackedFile(const std::filesystem::path& packed) : folder_("bag") {
  const int file = ::open(path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const std::unique_ptr<const int, void (*)(const int*)> closed(&file,
                                                                [](const int* f) { ::close(*f); });
  try {
    if (file < 0) throw core::Error(std::strerror(errno));
    unpack(packed, file);
  } catch (const core::Error& why) {
    throw core::Error(
        fmt::format("cannot unpack {} into {}: {}", packed.string(), path().string(), why.what()));
  }
}

void UnpackedFile::unpack(const std::filesystem::path& packed, int file) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                        ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  FileBytes in(packed);
  const std::uint64_t most = kMostGrowth * (in.left() + 1000);
  std::vector<char> out(kPiece);
  std::uint64_t written = 0;
  std::size_t code = 1;
  while (in.left() > 0) {
    const std::string_view piece = in.take(std::min(kPiece, in.left()));
    ZSTD_inBuffer from{piece.data(), piece.size(), 0};
    ZSTD_outBuffer to{out.data(), out.size(), out.size()};
    while (from.pos < from.size || to.pos == to.size) {
      to.pos = 0;
      code = ZSTD_decompressStream(context.get(), &to, &from);
      if (ZSTD_isError(code) != 0)
        throw BagDamage(fmt::format("the zstd data are damaged ({})", ZSTD_getErrorName(code)));
      write(file, out.data(), to.pos);
      written += to.pos;
      if (written > most) throw BagDamage("the zstd data grow to over 1000 times their size");
    }
  }
  if (code != 0) throw BagDamage("the zstd data end early");
}

}  // namespace ariadne::io::ros
