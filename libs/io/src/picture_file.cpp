#include "ariadne/io/picture_file.h"

#include <fmt/format.h>
#include <mrpt/img/CImage.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "picture_pixel.h"
#include "picture_size.h"
#include "png_reader.h"

namespace ariadne::io {
namespace {

/// OpenCV's decoders, through MRPT.
PicturePixels decodeOther(const std::filesystem::path& path) {
  constexpr int kAsItIs = -1;
  mrpt::img::CImage image;
  if (!image.loadFromFile(path.string(), kAsItIs))
    throw core::Error("it is damaged: it cannot be decoded");
  PicturePixels picture;
  picture.width = static_cast<int>(image.getWidth());
  picture.height = static_cast<int>(image.getHeight());
  PixelSink sink(picture, image.getChannelCount());
  for (unsigned y = 0; y < image.getHeight(); ++y) {
    if (image.getPixelDepth() == mrpt::img::PixelDepth::D8U)
      sink.row(image.ptrLine<std::uint8_t>(y));
    else if (image.getPixelDepth() == mrpt::img::PixelDepth::D16U)
      sink.row(image.ptrLine<std::uint16_t>(y), 8);
    else
      throw core::Error("its pixels have neither 8 nor 16 bits a colour");
  }
  // A BMP's fourth byte that is 0 everywhere is no transparency: it is not used.
  const auto& alpha = picture.alpha;
  if (std::all_of(alpha.begin(), alpha.end(), [](std::uint8_t a) { return a == 0; }))
    picture.alpha.clear();
  return picture;
}

}  // namespace

PicturePixels readPicture(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) readWhole(path, 0);  // says why
  try {
    expectPictureSize(path);
    return isPng(path) ? decodePng(readWhole(path)) : decodeOther(path);
  } catch (const std::exception& e) {
    const std::string why = e.what();
    throw core::Error(fmt::format("the picture {} cannot be read: {}", path.string(),
                                  why.substr(0, why.find('\n'))));
  }
}

}  // namespace ariadne::io
