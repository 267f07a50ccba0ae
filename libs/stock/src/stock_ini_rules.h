// Which key of a stock INI means what here: one table.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/io/ini_text.h"
#include "ariadne/slam/params.h"

namespace ariadne::stock {

/// What is gathered from a stock INI, key by key.
struct StockState {
  slam::SlamParams params;
  std::string rawlog_file;
  std::string output_folder;
  std::optional<double> insertion_distance_m;
  std::optional<double> insertion_angle_deg;
  std::optional<double> localize_distance_m;
  std::optional<double> localize_angle_deg;
  bool no_return_is_free = true;
  double occupied = 0.65;  ///< MRPT's default
  double free = 0;         ///< 0: as occupied
  int grids = 0;
  int point_maps = 0;
  bool counts_given = false;
  std::vector<std::string> notes;
};

struct StockRule {
  using Apply = std::function<void(StockState&, const io::IniEntry&)>;
  /// "" for [MappingApplication], else what its options section of the first grid ends in.
  const char* options;
  const char* key;
  Apply apply;
};

const std::vector<StockRule>& stockRules();

/// Keys that rbpf-slam knows and that mean nothing here (windows, logs, its own matcher).
const std::vector<std::string>& stockKeysWithoutMeaning();

}  // namespace ariadne::stock
