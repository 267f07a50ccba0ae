#include "readers.h"

#include <fstream>

#include "ariadne/core/error.h"
#include "parts.h"

namespace ariadne::fuzz {

const std::vector<Reader>& readers() {
  static const std::vector<Reader> all = {{"carmen", "in.log", readLog},
                                          {"rawlog", "in.rawlog", readLog},
                                          {"newer", "in.bin", readNewerObservation},
                                          {"bag", "in.bag", readLog},
                                          {"mcap", "in.mcap", readLog},
                                          {"db3", "in.db3", readLog},
                                          {"zstd", "in.db3.zstd", readLog},
                                          {"metadata", "metadata.yaml", readMetadata},
                                          {"tum", "in.tum", readTum},
                                          {"relations", "in.relations", readRelations},
                                          {"world", "in.world", readWorld},
                                          {"yaml", "in.yaml", readRosMap},
                                          {"gridmap", "in.gridmap.gz", readWorld},
                                          {"simplemap", "map.simplemap", readSimplemap},
                                          {"png", "in.png", readPicture},
                                          {"pgm", "in.pgm", readPicture},
                                          {"path", "in.path", readDrive},
                                          {"slam-ini", "in.ini", readSlamIni},
                                          {"log-or-ini", "in.txt", readLogOrIni},
                                          {"loop-ini", "in.ini", readLoopIni},
                                          {"experiment-ini", "in.ini", readExperimentIni},
                                          {"set", "in.txt", readSettings},
                                          {"require", "in.txt", readRequirement},
                                          {"plan", "plan.json", readPlan},
                                          {"result", "in.json", readResult},
                                          {"job", "job.json", readJob},
                                          {"joblog", "joblog.tsv", readJoblog},
                                          {"csv", "in.csv", readCsv},
                                          {"steps", "in.csv", readSteps},
                                          {"figures", "in.txt", readFigures}};
  return all;
}

bool tryReader(const Reader& reader, const std::filesystem::path& folder, std::string_view bytes) {
  const std::filesystem::path file = folder / reader.file;
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    reader.read(file);
  } catch (const core::Error&) {
    return false;
  }
  return true;
}

}  // namespace ariadne::fuzz
