// Maps as files for other programs. All are written whole or not at all and throw core::Error
// naming the path when that cannot be done, or when a grid has no cells (loaders refuse those). A
// cell is free when its log odds are over 0, occupied when under, unknown at exactly 0.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>

#include <filesystem>

namespace ariadne::io {

/// An 8-bit gray picture, one pixel a cell, north up: probability of being free, white is free.
/// Throws for a side over 1,000,000 cells too, which PNG readers refuse.
void writeMapPng(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map);

/// For ROS map_server (trinary): `pgm_file` and a .yaml of the same stem beside it, origin and
/// resolution in m. Pixels are 254 free, 0 occupied, 205 unknown.
void writeRosMap(const std::filesystem::path& pgm_file, const mrpt::maps::COccupancyGridMap2D& map);

/// MRPT's serialised COccupancyGridMap2D, gzip.
void writeGridmap(const std::filesystem::path& file, const mrpt::maps::COccupancyGridMap2D& map);

/// MRPT's serialised CSimpleMap, gzip.
void writeSimplemap(const std::filesystem::path& file, const mrpt::maps::CSimpleMap& map);

}  // namespace ariadne::io
