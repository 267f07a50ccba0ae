// The INI with which stock MRPT maps what ariadne-slam maps.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "config.h"

namespace ariadne::compare_app {

/// MRPT's own for PF_algorithm 2 on a grid, of the package mrpt-common.
constexpr const char* kDefaultStockIni =
    "/usr/share/mrpt/config_files/rbpf-slam/gridmapping_RBPF_grid_ICPbased_malaga.ini";

/// The file whose other settings stock takes: `given`, else CONFIG if it is of rbpf-slam, else
/// kDefaultStockIni.
std::filesystem::path stockBase(const std::string& given, const std::filesystem::path& config);

/// Its text with what both have in common set to ours: particles, resolution, distances between
/// updates (for localizing and inserting alike), insertion range; the number of particles fixed.
/// Throws core::UsageError for an INI that maps no occupancy grid, core::Error when unreadable.
std::string stockIniText(const std::filesystem::path& base, const slam::SlamParams& ours,
                         std::optional<int> pf_algorithm);

}  // namespace ariadne::compare_app
