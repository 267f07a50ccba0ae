#include "ariadne/experiment/loop_config_file.h"

#include "ariadne/io/dataset_place.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_text.h"

namespace ariadne::experiment {

LoopConfig readLoopConfig(const std::filesystem::path& file, const std::string& text,
                          const std::vector<std::string>& settings) {
  LoopConfig config;
  io::applyIni(config, io::parseIniFile(text, file));
  const std::filesystem::path folder = file.parent_path();
  for (std::string* named : {&config.files.world, &config.files.path})
    if (!named->empty()) *named = (folder / *named).string();
  for (const std::string& setting : settings) io::setField(config, io::parseSetting(setting));
  if (!config.files.log.empty())
    config.files.log = io::datasetPlace(config.files.log, folder).string();
  return config;
}

}  // namespace ariadne::experiment
