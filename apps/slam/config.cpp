#include "config.h"

#include <filesystem>

#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/stock/stock_ini.h"
#include "ini_program.h"

namespace ariadne::slam_app {
namespace {

namespace fs = std::filesystem;

ResolvedConfig fromStock(const std::string& text, const fs::path& file) {
  const stock::StockIni read = stock::readStockIni(text, file);
  ResolvedConfig out;
  out.config.slam = read.params;
  out.config.dataset.file = read.rawlog_file;
  out.config.run.out = read.output_folder;
  out.warnings = read.warnings;
  return out;
}

ResolvedConfig fromOwn(const std::string& text, const fs::path& file) {
  app::expectIniOf("ariadne-slam", file, text);
  ResolvedConfig out;
  io::applyIni(out.config, io::parseIniFile(text, file));
  std::string& dataset = out.config.dataset.file;
  if (!dataset.empty()) dataset = (file.parent_path() / dataset).string();
  return out;
}

ResolvedConfig fromFile(const fs::path& file) {
  const std::string text = io::readIniText(file);
  const auto lenient = io::parseIni(text, file.string(), io::IniDialect::mrpt);
  return stock::isStockIni(lenient) ? fromStock(text, file) : fromOwn(text, file);
}

}  // namespace

io::DatasetOptions optionsOf(const DatasetParams& params) {
  io::DatasetOptions options;
  options.laser_label = params.laser_label;
  options.field_of_view_deg = params.field_of_view_deg;
  options.max_range_m = params.max_range_m;
  options.min_range_m = params.min_range_m;
  options.use_odometry = params.odometry == OdometrySource::log;
  options.ros = {params.scan_topic, params.odom_topic, params.odom_frame, params.base_frame,
                 io::parseLaserPose(params.laser_pose, "[dataset] laser_pose")};
  return options;
}

ResolvedConfig resolveConfig(const Options& options) {
  ResolvedConfig resolved;
  if (!options.config_file.empty()) resolved = fromFile(options.config_file);
  for (const std::string& setting : options.settings)
    io::setField(resolved.config, io::parseSetting(setting));
  for (const io::IniEntry& entry : app::flagEntries(options)) io::setField(resolved.config, entry);
  if (!options.dataset.empty())
    io::setField(resolved.config, {"dataset", "file", options.dataset, "DATASET"});
  std::string& dataset = resolved.config.dataset.file;
  if (!dataset.empty()) {
    fs::path whole = fs::absolute(dataset).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();  // a folder, written with a slash
    dataset = whole.string();
  }
  return resolved;
}

std::string outputFolderOf(const SlamConfig& config) {
  return config.run.out.empty() ? app::newFolderFor(config.dataset.file) : config.run.out;
}

}  // namespace ariadne::slam_app
