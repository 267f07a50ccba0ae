// What a map of another program claims, checked before MRPT takes memory for it: MRPT believes any
// number, and multiplies in 32 bits.
#pragma once
#include <filesystem>

namespace ariadne::sim {

/// Throws core::Error for other than 1 to 1e8 cells.
void expectFewCells(double columns, double rows);

/// Of a .png, .pgm, .bmp or .jpg by its own header. Throws core::Error for one of over 1e8 pixels,
/// or of more than so few bytes can hold; what is no such picture passes.
void expectPictureCells(const std::filesystem::path& file);

}  // namespace ariadne::sim
