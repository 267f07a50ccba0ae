// A simple map (MRPT's CSimpleMap): laser scans with their poses. Read without believing it.
#pragma once
#include <mrpt/maps/CSimpleMap.h>

#include <filesystem>

namespace ariadne::io {

/// Reads a .simplemap of ours or of MRPT, gzip or not: of each pose the mean on the floor, of each
/// frame the laser scans along the floor, their beams as StepSource promises. What lies in a frame
/// besides scans is an error, since nobody knows where it ends.
/// Throws core::Error naming the file, entry and byte where it is no simple map, is damaged or
/// holds no scan.
mrpt::maps::CSimpleMap readSimplemap(const std::filesystem::path& file);

}  // namespace ariadne::io
