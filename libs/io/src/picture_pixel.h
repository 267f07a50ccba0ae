// From the channels of a decoder to gray levels and opacity.
#pragma once
#include <cstdint>

#include "ariadne/io/picture_file.h"

namespace ariadne::io {

/// Takes rows from the top: gray, gray and alpha, three colours, or three and alpha.
class PixelSink {
 public:
  /// `picture` has its size.
  PixelSink(PicturePixels& picture, std::size_t channels)
      : picture_(picture), channels_(channels), colours_(channels < 3 ? 1 : 3) {
    const auto pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.shade.reserve(pixels);
    if (channels_ > colours_) picture.alpha.reserve(pixels);
  }

  /// @param shift how many low bits of a value are dropped
  template <class T>
  void row(const T* values, unsigned shift = 0) {
    for (int x = 0; x < picture_.width; ++x, values += channels_) {
      unsigned sum = 0;
      for (std::size_t c = 0; c < colours_; ++c) sum += static_cast<unsigned>(values[c]) >> shift;
      picture_.shade.push_back(static_cast<std::uint8_t>((sum + colours_ / 2) / colours_));
      if (channels_ > colours_)
        picture_.alpha.push_back(static_cast<std::uint8_t>(values[colours_] >> shift));
    }
  }

 private:
  PicturePixels& picture_;
  std::size_t channels_;
  std::size_t colours_;
};

}  // namespace ariadne::io
