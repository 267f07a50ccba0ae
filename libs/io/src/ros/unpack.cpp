#include "unpack.h"

#include <bzlib.h>
#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "bag_reader.h"

namespace ariadne::io::ros {
namespace {

constexpr std::uint64_t kMostUnpacked = 1 << 30;
constexpr std::size_t kFirstStep = 1 << 20;

BagDamage damaged(const char* codec, const std::string& why) {
  return BagDamage(fmt::format("the {} data are damaged ({})", codec, why));
}

/// Where unpacked bytes go: grows as they come, up to a limit.
class Output {
 public:
  explicit Output(std::uint64_t most) : most_(most) {}
  /// Room for more bytes; of no size when the limit is reached.
  std::size_t room() {
    if (used_ == bytes_.size())
      bytes_.resize(static_cast<std::size_t>(
          std::min<std::uint64_t>(most_, std::max<std::uint64_t>(kFirstStep, 2 * used_))));
    return bytes_.size() - used_;
  }
  char* end() { return bytes_.data() + used_; }
  void add(std::size_t count) { used_ += count; }
  std::vector<char> finish() {
    bytes_.resize(used_);
    return std::move(bytes_);
  }

 private:
  std::vector<char> bytes_;
  std::uint64_t most_;
  std::size_t used_ = 0;
};

/// The bytes after the limit are of interest only in that there are some.
void requireRoom(std::size_t room, const char* codec) {
  if (room == 0) throw damaged(codec, "more comes out than is announced");
}

void unpackBz2(std::string_view packed, Output& out) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::bad_alloc();
  const std::unique_ptr<bz_stream, int (*)(bz_stream*)> owner(&stream, BZ2_bzDecompressEnd);
  stream.next_in = const_cast<char*>(packed.data());
  stream.avail_in = static_cast<unsigned>(packed.size());
  char beyond = 0;
  for (;;) {
    const std::size_t room = out.room();
    stream.next_out = room > 0 ? out.end() : &beyond;
    stream.avail_out = static_cast<unsigned>(std::max<std::size_t>(room, 1));
    const unsigned before = stream.avail_out;
    const unsigned input_before = stream.avail_in;
    const int code = BZ2_bzDecompress(&stream);
    const std::size_t got = before - stream.avail_out;
    if (got > 0) requireRoom(room, "bz2");
    out.add(got);
    if (code == BZ_STREAM_END) return;
    if (code == BZ_MEM_ERROR) throw std::bad_alloc();
    if (code != BZ_OK) throw damaged("bz2", fmt::format("code {}", code));
    if (got == 0 && stream.avail_in == input_before) throw damaged("bz2", "they end early");
  }
}

void unpackLz4(std::string_view packed, Output& out) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0)
    throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(
      made, LZ4F_freeDecompressionContext);
  char beyond = 0;
  for (;;) {
    const std::size_t room = out.room();
    std::size_t got = std::max<std::size_t>(room, 1), used = packed.size();
    const std::size_t code =
        LZ4F_decompress(made, room > 0 ? out.end() : &beyond, &got, packed.data(), &used, nullptr);
    if (LZ4F_isError(code) != 0) throw damaged("lz4", LZ4F_getErrorName(code));
    if (got > 0) requireRoom(room, "lz4");
    out.add(got);
    packed.remove_prefix(used);
    if (code == 0) return;
    if (got == 0 && used == 0) throw damaged("lz4", "they end early");
  }
}

void unpackZstd(std::string_view packed, Output& out) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                        ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  char beyond = 0;
  for (;;) {
    const std::size_t room = out.room();
    ZSTD_outBuffer to{room > 0 ? out.end() : &beyond, std::max<std::size_t>(room, 1), 0};
    const std::size_t used_before = in.pos;
    const std::size_t code = ZSTD_decompressStream(context.get(), &to, &in);
    if (ZSTD_isError(code) != 0) throw damaged("zstd", ZSTD_getErrorName(code));
    if (to.pos > 0) requireRoom(room, "zstd");
    out.add(to.pos);
    if (code == 0 && in.pos == in.size) return;
    if (to.pos == 0 && in.pos == used_before) throw damaged("zstd", "they end early");
  }
}

}  // namespace

std::optional<Codec> codecOf(std::string_view name) {
  if (name.empty() || name == "none") return Codec::none;
  if (name == "bz2") return Codec::bz2;
  if (name == "lz4") return Codec::lz4;
  if (name == "zstd") return Codec::zstd;
  return std::nullopt;
}

bool looksLikeZstd(std::string_view bytes) {
  return bytes.substr(0, 4) == std::string_view("\x28\xb5\x2f\xfd", 4);
}

std::vector<char> unpack(Codec codec, std::string_view packed, std::uint64_t size) {
  if (size > kMostUnpacked)
    throw BagDamage(fmt::format("a chunk claims {} bytes, over 1 GiB", size));
  if (packed.size() > kMostUnpacked)
    throw BagDamage(fmt::format("a packed chunk of {} bytes, over 1 GiB", packed.size()));
  Output out(size);
  if (codec == Codec::bz2) unpackBz2(packed, out);
  if (codec == Codec::lz4) unpackLz4(packed, out);
  if (codec == Codec::zstd) unpackZstd(packed, out);
  std::vector<char> bytes =
      codec == Codec::none ? std::vector<char>(packed.begin(), packed.end()) : out.finish();
  if (bytes.size() != size)
    throw BagDamage(fmt::format("a chunk of {} bytes announces {}", bytes.size(), size));
  return bytes;
}

std::vector<char> unpackZstd(std::string_view packed, std::size_t most) {
  Output out(most);
  unpackZstd(packed, out);
  return out.finish();
}

}  // namespace ariadne::io::ros
