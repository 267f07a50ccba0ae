// A Cairo image as a PNG file.
#pragma once
#include <filesystem>

#include "canvas.h"

namespace ariadne::report {

/// @param surface of CAIRO_FORMAT_RGB24. Throws core::Error naming the file.
void writePng(const std::filesystem::path& file, const Surface& surface);

}  // namespace ariadne::report
