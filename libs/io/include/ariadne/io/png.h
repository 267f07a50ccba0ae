// 8-bit PNG pictures by libpng, quickly: a map is written at the end of every run, so compression
// is at its lowest.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace ariadne::io {

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int channels = 1;                  ///< 1 gray, 3 RGB
  std::vector<std::uint8_t> pixels;  ///< row by row from the top, width * channels a row
};

/// The PNG as bytes. Throws core::Error when libpng cannot make it (a side over 1,000,000).
std::string encodePng(const Picture& picture);

}  // namespace ariadne::io
