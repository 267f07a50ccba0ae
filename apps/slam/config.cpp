#include "config.h"

#include <filesystem>

#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/stock_ini.h"
#include "ini_program.h"

namespace ariadne::slam_app {
namespace {

namespace fs = std::filesystem;

ResolvedConfig fromStock(const std::string& text, const fs::path& file) {
  const io::StockIni stock = io::readStockIni(text, file);
  ResolvedConfig out;
  out.config.slam = stock.params;
  out.config.dataset.file = stock.rawlog_file;
  out.config.run.out = stock.output_folder;
  out.warnings = stock.warnings;
  return out;
}

ResolvedConfig fromOwn(const std::string& text, const fs::path& file) {
  app::expectIniOf("ariadne-slam", file, text);
  ResolvedConfig out;
  io::applyIni(out.config, io::parseIni(text, file.string(), io::IniDialect::strict));
  std::string& dataset = out.config.dataset.file;
  if (!dataset.empty()) dataset = (file.parent_path() / dataset).string();
  return out;
}

ResolvedConfig fromFile(const fs::path& file) {
  const std::string text = io::readIniText(file);
  const auto lenient = io::parseIni(text, file.string(), io::IniDialect::mrpt);
  return io::isStockIni(lenient) ? fromStock(text, file) : fromOwn(text, file);
}

/// The dedicated flags as entries, so that they are checked and explained like the INI's.
std::vector<io::IniEntry> flagEntries(const Options& o) {
  std::vector<io::IniEntry> entries;
  if (o.particles) entries.push_back({"filter", "particles", *o.particles, "--particles"});
  if (o.seed) entries.push_back({"filter", "seed", *o.seed, "--seed"});
  if (o.threads) entries.push_back({"run", "threads", *o.threads, "--threads"});
  if (o.out) entries.push_back({"run", "out", *o.out, "--out"});
  if (o.no_pictures) entries.push_back({"run", "pictures", "false", "--no-pictures"});
  if (!o.dataset.empty()) entries.push_back({"dataset", "file", o.dataset, "DATASET"});
  return entries;
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
  for (const io::IniEntry& entry : flagEntries(options)) io::setField(resolved.config, entry);
  std::string& dataset = resolved.config.dataset.file;
  if (!dataset.empty()) {
    fs::path whole = fs::absolute(dataset).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();  // a folder, written with a slash
    dataset = whole.string();
  }
  return resolved;
}

std::string outputFolderOf(const SlamConfig& config) {
  return config.run.out.empty() ? newFolderFor(config.dataset.file) : config.run.out;
}

}  // namespace ariadne::slam_app
