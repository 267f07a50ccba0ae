#include "stock_settings.h"

#include <mrpt/config/CConfigFileMemory.h>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/stock/stock_ini.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;
const std::string kSection = "MappingApplication";
const std::string kGrid = kSection + "_occupancyGrid_00_";

bool isStock(const fs::path& file) {
  return stock::isStockIni(
      io::parseIni(io::readIniText(file), file.string(), io::IniDialect::mrpt));
}

}  // namespace

fs::path stockBase(const std::string& given, const fs::path& config) {
  if (!given.empty()) return given;
  if (isStock(config)) return config;
  std::error_code ignored;
  if (!fs::exists(kDefaultStockIni, ignored))
    throw core::Error(std::string(kDefaultStockIni) +
                      " is missing: install mrpt-common, or name an INI with --stock-ini");
  return kDefaultStockIni;
}

std::string stockIniText(const fs::path& base, const slam::SlamParams& ours,
                         std::optional<int> pf_algorithm) {
  const std::string text = io::readIniText(base);
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text);
  if (ini.read_int(kSection, "occupancyGrid_count", 0) < 1)
    throw core::UsageError(base.string() +
                           ": [MappingApplication] occupancyGrid_count is not 1 or "
                           "more: stock would map no grid that can be compared");
  ini.write(kSection, "sampleSize", ours.filter.particles);
  ini.write(kSection, "adaptiveSampleSize", 0);
  if (pf_algorithm) ini.write(kSection, "PF_algorithm", *pf_algorithm);
  for (const char* what : {"insertion", "localize"}) {
    ini.write(kSection, std::string(what) + "LinDistance", ours.update.update_distance_m);
    ini.write(kSection, std::string(what) + "AngDistance_deg", ours.update.update_angle_deg);
  }
  ini.write(kGrid + "creationOpts", "resolution", ours.grid.resolution_m);
  ini.write(kGrid + "insertOpts", "maxDistanceInsertion", ours.grid.insert_range_m);
  return ini.getContent();
}

}  // namespace ariadne::compare_app
