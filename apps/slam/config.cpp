#include "config.h"

#include <filesystem>
#include <optional>

#include "ariadne/core/error.h"
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
  std::string& known = out.config.continue_from.run;
  if (!known.empty()) known = (file.parent_path() / known).string();
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

namespace {

/// Without an INI a run is gone on with by its own settings, into another folder.
ResolvedConfig fromRun(const fs::path& run) {
  for (const char* name : {"mapping.ini", "config.ini"}) {  // the first: ariadne-explore's
    if (std::error_code ignored; !fs::exists(run / name, ignored)) continue;
    ResolvedConfig resolved = fromFile(run / name);
    resolved.config.run.out.clear();
    resolved.config.continue_from = {};
    return resolved;
  }
  return {};
}

void makeAbsolute(std::string& file) {
  if (file.empty()) return;
  fs::path whole = fs::absolute(file).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // a folder, written with a slash
  file = whole.string();
}

}  // namespace

ResolvedConfig resolveConfig(const Options& options) {
  ResolvedConfig resolved;
  if (!options.config_file.empty())
    resolved = fromFile(options.config_file);
  else if (options.continue_from)
    resolved = fromRun(*options.continue_from);
  for (const std::string& setting : options.settings)
    io::setField(resolved.config, io::parseSetting(setting));
  for (const io::IniEntry& entry : app::flagEntries(options)) io::setField(resolved.config, entry);
  const auto set = [&](const char* section, const char* key,
                       const std::optional<std::string>& value, const char* flag) {
    if (value) io::setField(resolved.config, {section, key, *value, flag});
  };
  set("continue", "run", options.continue_from, "--continue");
  set("continue", "start", options.start, "--start");
  if (!options.dataset.empty())
    io::setField(resolved.config, {"dataset", "file", options.dataset, "DATASET"});
  makeAbsolute(resolved.config.dataset.file);
  makeAbsolute(resolved.config.continue_from.run);
  if (resolved.config.continue_from.run.empty() && !resolved.config.continue_from.start.empty())
    throw core::UsageError(
        "[continue] start is where the robot is in a map that is gone on with: name that by "
        "--continue RUN");
  return resolved;
}

std::string outputFolderOf(const SlamConfig& config) {
  return config.run.out.empty() ? app::newFolderFor(config.dataset.file) : config.run.out;
}

}  // namespace ariadne::slam_app
