// What a picture claims of its size, checked before memory is taken for it.
#pragma once
#include <filesystem>

namespace ariadne::io {

/// By the header of a .png, .pgm, .pbm, .ppm, .bmp or .jpg. Throws core::Error for one of over 1e8
/// pixels, or of more than so few bytes can hold, and for what is no such picture.
void expectPictureSize(const std::filesystem::path& file);

bool isPng(const std::filesystem::path& file);

}  // namespace ariadne::io
