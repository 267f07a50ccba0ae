// MRPT's gridmap files, read without believing them: MRPT resizes its cells and lists to whatever
// count the file claims, and takes a short read for a whole one.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

namespace ariadne::sim {

/// The cells of a .gridmap or .gridmap.gz; what it says of insertion and likelihood is left alone.
/// Throws core::Error saying what is wrong.
mrpt::maps::COccupancyGridMap2D readGridmap(const std::filesystem::path& file);

}  // namespace ariadne::sim
