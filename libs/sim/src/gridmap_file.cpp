#include "gridmap_file.h"

#include <fmt/format.h>
#include <mrpt/io/CFileGZInputStream.h>

#include <cmath>
#include <cstdint>

#include "ariadne/core/error.h"
#include "world_cells.h"

namespace ariadne::sim {
namespace {

class Bytes {
 public:
  explicit Bytes(const std::filesystem::path& path) : file_(path.string()) {}
  void read(void* to, std::size_t count) {
    if (file_.Read(to, count) != count) throw core::Error("the file ends early");
  }
  /// As it lies in the file, little-endian.
  template <class T>
  T number() {
    T value;
    read(&value, sizeof(T));
    return value;
  }

 private:
  mrpt::io::CFileGZInputStream file_;
};

void expectFewCells(double columns, double rows) {
  if (!(columns >= 1 && rows >= 1 && columns * rows <= kMostCells))
    throw core::Error(
        fmt::format("it claims {} x {} cells; a world has 1 to {:.0e}", columns, rows, kMostCells));
}

/// 0x80 | length, name, version.
void readHeader(Bytes& in) {
  const auto first = in.number<std::uint8_t>();
  std::string name(first & 0x7fU, '\0');
  if (first >= 0x80) in.read(name.data(), name.size());
  if (name != "COccupancyGridMap2D" && name != "mrpt::maps::COccupancyGridMap2D")
    throw core::Error("it does not begin with a COccupancyGridMap2D");
  const auto version = in.number<std::uint8_t>();
  if (version < 3 || version > 6)
    throw core::Error(fmt::format("a COccupancyGridMap2D of version {}; 3 to 6 are read", version));
  if (in.number<std::uint8_t>() != 8) throw core::Error("its cells are not of 8 bits");
}

}  // namespace

mrpt::maps::COccupancyGridMap2D readGridmap(const std::filesystem::path& file) {
  Bytes in(file);
  readHeader(in);
  const auto columns = in.number<std::uint32_t>();
  const auto rows = in.number<std::uint32_t>();
  expectFewCells(columns, rows);
  float sides[4];  // low and high x, low and high y
  in.read(sides, sizeof(sides));
  const auto resolution_m = in.number<float>();
  const auto fits = [&](float low, float high, double cells) {
    return std::abs(low) < 1e5F && std::abs((double{high} - low) / resolution_m - cells) < 0.5;
  };
  if (!(resolution_m >= 0.005F && resolution_m <= 0.5F))
    throw core::Error(
        fmt::format("cells of {} m; a world has cells of 0.005 to 0.5 m", resolution_m));
  if (!fits(sides[0], sides[1], columns) || !fits(sides[2], sides[3], rows))
    throw core::Error(fmt::format("{} x {} cells of {} m do not fit the sides it claims", columns,
                                  rows, resolution_m));
  // Row by row into a map that grows with what is there, then as a whole.
  std::string cells;
  for (std::uint32_t row = 0; row < rows; ++row) {
    cells.resize(cells.size() + columns);
    in.read(cells.data() + cells.size() - columns, columns);
  }
  mrpt::maps::COccupancyGridMap2D map(sides[0], sides[1], sides[2], sides[3], resolution_m);
  if (map.getSizeX() != columns || map.getSizeY() != rows)
    throw core::Error(fmt::format("MRPT makes {} x {} cells of its {} x {}", map.getSizeX(),
                                  map.getSizeY(), columns, rows));
  for (std::uint32_t row = 0; row < rows; ++row)
    std::copy_n(cells.data() + std::size_t{row} * columns, columns,
                map.getRow(static_cast<int>(row)));
  return map;
}

}  // namespace ariadne::sim
