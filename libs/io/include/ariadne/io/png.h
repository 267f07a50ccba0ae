// PNG pictures by libpng. Those of 8 bits quickly: a map is written at the end of every run, so
// compression is at its lowest.
#pragma once
#include <cstdint>
#include <string>

namespace ariadne::io {

/// Somebody else's pixels.
struct Picture {
  /// How the pixels lie in memory.
  enum class Format {
    gray,          ///< one byte a pixel
    cairo_rgb,     ///< CAIRO_FORMAT_RGB24 of a little-endian machine: blue, green, red, unused
    two_bit_gray,  ///< four pixels a byte, the first in the highest bits; compressed well
  };
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Format format = Format::gray;
  const std::uint8_t* pixels = nullptr;  ///< row by row from the top
  std::size_t stride = 0;                ///< bytes from row to row
};

/// The PNG as bytes. Throws core::Error when libpng cannot make it (a side over 1,000,000).
std::string encodePng(const Picture& picture);

}  // namespace ariadne::io
