#include "png_reader.h"

#include <fmt/format.h>
#include <png.h>

#include <cstring>

#include "ariadne/core/error.h"
#include "picture_pixel.h"

namespace ariadne::io {
namespace {

[[noreturn]] void failReading(png_structp, png_const_charp message) {
  throw core::Error(fmt::format("it is damaged: {}", message));
}

void ignoreWarning(png_structp, png_const_charp) {}  // an error follows where it matters

struct PngSource {
  const std::string& bytes;
  std::size_t at = 0;
};

void take(png_structp png, png_bytep to, png_size_t count) {
  auto& source = *static_cast<PngSource*>(png_get_io_ptr(png));
  if (source.bytes.size() - source.at < count) failReading(png, "it ends early");
  std::memcpy(to, source.bytes.data() + source.at, count);
  source.at += count;
}

struct PngReader {
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, failReading, ignoreWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  PngReader() = default;
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
};

}  // namespace

PicturePixels decodePng(const std::string& bytes) {
  PngReader r;
  if (!r.info) throw core::Error("out of memory");
  PngSource source{bytes};
  png_set_read_fn(r.png, &source, take);
  png_read_info(r.png, r.info);
  png_set_expand(r.png);  // palettes, bits and transparent colours become bytes a channel
  png_set_scale_16(r.png);
  const int passes = png_set_interlace_handling(r.png);
  png_read_update_info(r.png, r.info);
  PicturePixels picture;
  picture.width = static_cast<int>(png_get_image_width(r.png, r.info));
  picture.height = static_cast<int>(png_get_image_height(r.png, r.info));
  const std::size_t channels = png_get_channels(r.png, r.info);
  const std::size_t stride = png_get_rowbytes(r.png, r.info);
  // Rows of an interlaced picture are complete with the last pass.
  std::vector<std::uint8_t> rows(stride *
                                 (passes > 1 ? static_cast<std::size_t>(picture.height) : 1));
  PixelSink sink(picture, channels);
  for (int pass = 0; pass < passes; ++pass)
    for (int y = 0; y < picture.height; ++y) {
      std::uint8_t* row = rows.data() + (passes > 1 ? static_cast<std::size_t>(y) * stride : 0);
      png_read_row(r.png, row, nullptr);
      if (pass + 1 == passes) sink.row(row);
    }
  return picture;
}

}  // namespace ariadne::io
