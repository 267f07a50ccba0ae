// PNGs of every kind, by libpng.
#pragma once
#include <png.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ariadne::test {

struct PngKind {
  int color_type = PNG_COLOR_TYPE_GRAY;
  int bits = 8;
  int interlace = PNG_INTERLACE_NONE;
  /// Adds a palette or a transparent colour.
  std::function<void(png_structp, png_infop)> more = [](png_structp, png_infop) {};
};

/// @param rows bytes as the file has them
inline std::string pngBytes(std::uint32_t width, const PngKind& kind,
                            std::vector<std::vector<std::uint8_t>> rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto append = [](png_structp p, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<char*>(data), size);
  };
  png_set_write_fn(png, &bytes, append, nullptr);
  png_set_IHDR(png, info, width, static_cast<std::uint32_t>(rows.size()), kind.bits,
               kind.color_type, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  kind.more(png, info);
  png_write_info(png, info);
  std::vector<png_bytep> pointers;
  for (auto& row : rows) pointers.push_back(row.data());
  png_write_image(png, pointers.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace ariadne::test
