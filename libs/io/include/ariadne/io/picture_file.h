// Pictures that hold a map, as pixels.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace ariadne::io {

/// A picture in grey, decoded.
struct PicturePixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> shade;  ///< row by row from the top: mean of red, green and blue
  std::vector<std::uint8_t> alpha;  ///< 255 is opaque; empty when all are

  /// Whether the pixel is not transparent at all.
  bool opaque(std::size_t pixel) const { return alpha.empty() || alpha[pixel] == 255; }
};

/// A PNG by libpng, with transparency in each of its forms; a PGM, PBM, PPM, BMP or JPEG by MRPT.
/// More than 8 bits a colour are scaled down to 8. Throws core::Error naming the file: another kind
/// of picture, a damaged one, over 1e8 pixels or more than so few bytes can hold.
PicturePixels readPicture(const std::filesystem::path& path);

}  // namespace ariadne::io
