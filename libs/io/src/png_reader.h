// PNG pictures as gray levels and opacity, by libpng.
#pragma once
#include <string>

#include "ariadne/io/picture_file.h"

namespace ariadne::io {

/// Throws core::Error saying what is wrong with the bytes.
PicturePixels decodePng(const std::string& bytes);

}  // namespace ariadne::io
