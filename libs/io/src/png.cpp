#include "ariadne/io/png.h"

#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <string>

#include "ariadne/core/error.h"

namespace ariadne::io {
namespace {

[[noreturn]] void fail(png_structp, png_const_charp message) {
  throw core::Error(fmt::format("cannot make a PNG: {}", message));
}

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}

void ignore(png_structp, png_const_charp) {}  // an error follows where it matters

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

std::string encodePng(const Picture& picture) {
  Writer w;
  if (!w.info) throw core::Error("cannot make a PNG: out of memory");
  std::string bytes;
  png_set_write_fn(w.png, &bytes, append, nullptr);
  const bool small = picture.format == Picture::Format::two_bit_gray;
  const bool colours = picture.format == Picture::Format::cairo_rgb;
  png_set_IHDR(w.png, w.info, picture.width, picture.height, small ? 2 : 8,
               colours ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // 9 takes twenty times as long as 5 for a tenth less.
  png_set_compression_level(w.png, small ? 5 : 1);
  // Maps are flat: runs alone are quicker to find, and make a smaller file at this level.
  png_set_compression_strategy(w.png, small ? Z_DEFAULT_STRATEGY : Z_RLE);
  // Runs need no hash table, but zlib moves it along with its window: a smaller one.
  if (!small) png_set_compression_mem_level(w.png, 6);
  png_set_filter(w.png, 0, PNG_FILTER_NONE);
  png_write_info(w.png, w.info);
  if (colours) {
    png_set_bgr(w.png);
    png_set_filler(w.png, 0, PNG_FILLER_AFTER);
  }
  for (std::uint32_t y = 0; y < picture.height; ++y)
    png_write_row(w.png, picture.pixels + y * picture.stride);
  png_write_end(w.png, nullptr);
  return bytes;
}

}  // namespace ariadne::io
