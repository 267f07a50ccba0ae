#include "picture_size.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "ariadne/core/error.h"

namespace ariadne::io {
namespace {

constexpr double kMostPixels = 1e8;
constexpr std::size_t kHead = 1 << 16;  // a JPEG's frame stands behind comments and thumbnails
// Deflate makes at best 1032 bytes of one, and a byte holds eight pixels at most.
constexpr double kMostPixelsOfAByte = 8 * 1032;

struct Size {
  double columns = 0, rows = 0;
};

double bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
  double value = 0;
  for (std::size_t i = at; i < at + count; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Behind its letters a PGM or PPM says width, height and its brightest value in words, between
/// comments; a PBM (1 and 4) has no such value.
std::optional<Size> sizeOfPnm(const std::string& bytes) {
  std::istringstream in(bytes.substr(2));
  Size size;
  double brightest = 255;
  std::vector<double*> numbers{&size.columns, &size.rows};
  if (bytes[1] != '1' && bytes[1] != '4') numbers.push_back(&brightest);
  for (double* number : numbers) {
    while ((in >> std::ws).peek() == '#') in.ignore(1 << 20, '\n');
    if (!(in >> *number)) return std::nullopt;
  }
  if (brightest != 255 && brightest != 65535)  // OpenCV leaves values of others as they are
    throw core::Error(fmt::format("its brightest value is {}; takes 255 or 65535", brightest));
  return size;
}

/// In the frame of a JPEG, which segments of any kind may precede.
std::optional<Size> sizeOfJpeg(const std::string& bytes) {
  for (std::size_t at = 2; at + 9 < bytes.size() && bytes[at] == '\xff';) {
    const auto kind = static_cast<unsigned char>(bytes[at + 1]);
    if (kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc)
      return Size{bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
    at += 2 + static_cast<std::size_t>(bigEndian(bytes, at + 2, 2));
  }
  return std::nullopt;
}

/// Four bytes, the lowest first; a picture that stands on its head has a negative height.
double sideOfBmp(const std::string& bytes, std::size_t at) {
  const double value = bigEndian(
      {bytes.rbegin() + static_cast<std::ptrdiff_t>(bytes.size() - at - 4), bytes.rend()}, 0, 4);
  return value < 2147483648.0 ? value : 4294967296.0 - value;
}

std::optional<Size> sizeOfPicture(const std::string& bytes) {
  const auto begins = [&](const char* with) { return bytes.rfind(with, 0) == 0; };
  if (begins("\x89PNG") && bytes.size() >= 24)
    return Size{bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
  if (begins("BM") && bytes.size() >= 26) return Size{sideOfBmp(bytes, 18), sideOfBmp(bytes, 22)};
  if (begins("\xff\xd8")) return sizeOfJpeg(bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6')
    return sizeOfPnm(bytes);
  return std::nullopt;
}

std::string headOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHead, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

}  // namespace

bool isPng(const std::filesystem::path& path) { return headOf(path).rfind("\x89PNG", 0) == 0; }

void expectPictureSize(const std::filesystem::path& path) {
  const auto size = sizeOfPicture(headOf(path));
  if (!size) throw core::Error("it is no PNG, PGM, PBM, PPM, BMP or JPEG");
  if (!(size->columns >= 1 && size->rows >= 1 && size->columns * size->rows <= kMostPixels))
    throw core::Error(fmt::format("it claims {} x {} pixels; a map has 1 to {:.0e}", size->columns,
                                  size->rows, kMostPixels));
  std::error_code ignored;
  const auto bytes = static_cast<double>(std::filesystem::file_size(path, ignored));
  if (size->columns * size->rows > kMostPixelsOfAByte * bytes)
    throw core::Error(
        fmt::format("it claims {} x {} pixels in {} bytes", size->columns, size->rows, bytes));
}

}  // namespace ariadne::io
