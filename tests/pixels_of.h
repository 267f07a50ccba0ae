// What a picture shows, counted.
#pragma once
#include <mrpt/img/CImage.h>

#include <cmath>
#include <cstddef>
#include <filesystem>

namespace ariadne::test {

/// Pixels of about this colour, shares of red, green and blue. The file is gone then.
inline std::size_t pixelsOf(const std::filesystem::path& file, double r, double g, double b) {
  const auto image = mrpt::img::CImage::LoadFromFile(file.string());
  std::size_t n = 0;
  for (unsigned y = 0; y < image.getHeight(); ++y)
    for (unsigned x = 0; x < image.getWidth(); ++x) {
      const auto close = [&](int channel, double share) {
        return std::abs(*image(x, y, channel) - 255 * share) < 4;
      };
      n += close(2, r) && close(1, g) && close(0, b);
    }
  std::filesystem::remove(file);
  return n;
}

}  // namespace ariadne::test
