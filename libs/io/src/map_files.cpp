#include "ariadne/io/map_files.h"

#include <fmt/format.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "ariadne/core/error.h"
#include "ariadne/io/png.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;
using Grid = mrpt::maps::COccupancyGridMap2D;

constexpr std::uint8_t kFree = 254;
constexpr std::uint8_t kOccupied = 0;
constexpr std::uint8_t kUnknown = 205;

void requireCells(const fs::path& file, const Grid& map) {
  if (map.getSizeX() == 0 || map.getSizeY() == 0)
    throw core::Error(fmt::format("cannot write {}: the map has no cells", file.string()));
}

/// `header`, then one byte a cell, the northernmost row first.
template <class Shade>
std::string shades(const Grid& map, std::string_view header, Shade&& shade) {
  std::array<char, 256> shade_of{};
  for (int c = -128; c < 128; ++c)
    shade_of[static_cast<std::uint8_t>(c)] =
        static_cast<char>(shade(static_cast<Grid::cellType>(c)));
  std::string pixels(header.size() + std::size_t{map.getSizeX()} * map.getSizeY(), '\0');
  char* pixel = std::copy(header.begin(), header.end(), pixels.data());
  for (int y = static_cast<int>(map.getSizeY()); y-- > 0;) {
    const auto* row = map.getRow(y);
    pixel = std::transform(row, row + map.getSizeX(), pixel,
                           [&](auto c) { return shade_of[static_cast<std::uint8_t>(c)]; });
  }
  return pixels;
}

struct Deflater {
  z_stream stream{};
  Deflater() {
    constexpr int kGzip = 16;
    constexpr int kMemLevel = 6;  // runs need no hash table, but zlib moves it along: a smaller one
    if (deflateInit2(&stream, 1, Z_DEFLATED, MAX_WBITS + kGzip, kMemLevel, Z_RLE) != Z_OK)
      throw core::Error("cannot compress: out of memory");
  }
  ~Deflater() { deflateEnd(&stream); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
};

/// In memory: MRPT's own gzip file hides what fails when it is closed, such as a full disk.
std::string gzip(const void* data, std::size_t size) {
  Deflater d;
  d.stream.next_in = static_cast<Bytef*>(const_cast<void*>(data));
  std::string out;
  const auto* const end = static_cast<const Bytef*>(data) + size;
  char block[1 << 16];
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    const auto left = static_cast<std::size_t>(end - d.stream.next_in);
    d.stream.avail_in = static_cast<uInt>(std::min<std::size_t>(left, 1U << 30));
    d.stream.next_out = reinterpret_cast<Bytef*>(block);
    d.stream.avail_out = sizeof(block);
    state = deflate(&d.stream, left <= (1U << 30) ? Z_FINISH : Z_NO_FLUSH);
    if (state == Z_STREAM_ERROR) throw core::Error("cannot compress: zlib's stream error");
    out.append(block, sizeof(block) - d.stream.avail_out);
  }
  return out;
}

template <class T>
void writeSerialised(const fs::path& file, const T& object) {
  mrpt::io::CMemoryStream memory;
  auto archive = mrpt::serialization::archiveFrom(memory);
  archive << object;
  writeWhole(file, gzip(memory.getRawBufferData(), memory.getTotalBytesCount()));
}

/// As a YAML string: a file name may hold a colon, a hash or spaces.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

void writeMapPng(const fs::path& file, const Grid& map) {
  requireCells(file, map);
  const std::string pixels = shades(map, "", [](Grid::cellType c) { return Grid::l2p_255(c); });
  Picture picture;
  picture.width = map.getSizeX();
  picture.height = map.getSizeY();
  picture.pixels = reinterpret_cast<const std::uint8_t*>(pixels.data());
  picture.stride = picture.width;
  std::string png;
  try {
    png = encodePng(picture);
  } catch (const core::Error& e) {
    throw core::Error(fmt::format("cannot write {}, {} x {} cells: {}", file.string(),
                                  picture.width, picture.height, e.what()));
  }
  writeWhole(file, png);
}

void writeRosMap(const fs::path& pgm_file, const Grid& map) {
  requireCells(pgm_file, map);
  const std::string header = fmt::format("P5\n{} {}\n255\n", map.getSizeX(), map.getSizeY());
  writeWhole(pgm_file, shades(map, header, [](Grid::cellType c) {
               return c > 0 ? kFree : c < 0 ? kOccupied : kUnknown;
             }));

  fs::path yaml = pgm_file;
  yaml.replace_extension(".yaml");
  // 205 is 0.196 occupied: well between the thresholds, whichever way a loader rounds. The floats
  // are printed with all digits that matter: loaders snap the origin to whole cells, so a
  // resolution of 1/30 m cut to 0.033333 would move the map.
  writeWhole(yaml, fmt::format("image: {}\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0.0]\n"
                               "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.15\n",
                               quoted(pgm_file.filename().string()), map.getResolution(),
                               map.getXMin(), map.getYMin()));
}

void writeGridmap(const fs::path& file, const Grid& map) {
  requireCells(file, map);  // MRPT would not load it again
  writeSerialised(file, map);
}

void writeSimplemap(const fs::path& file, const mrpt::maps::CSimpleMap& map) {
  writeSerialised(file, map);
}

}  // namespace ariadne::io
