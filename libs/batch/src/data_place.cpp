#include "data_place.h"

#include <fmt/format.h>

#include <filesystem>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset_files.h"

namespace ariadne::batch {

const char* const kWhereDataAre =
    "Worlds and drives are in datasets/ (ariadne-dataset makes others); MRPT's sample log comes "
    "with the package mrpt-common; the others, as the Infinite Corridor, Intel and MIT CSAIL, are "
    "at http://ais.informatik.uni-freiburg.de/slamevaluation/datasets.php and the Radish archive's "
    "mirrors (README.md, \"Logs\"): put them into ../shared/datasets or where ARIADNE_DATASETS "
    "says";

std::string whyNoData(const std::string& path) {
  std::error_code ignored;
  const bool absolute = !path.empty() && path[0] == '/';
  if (absolute && std::filesystem::is_regular_file(path, ignored)) return "";
  if (!absolute || !std::filesystem::is_directory(path, ignored))
    return fmt::format("there is no such file. {}", kWhereDataAre);
  try {
    io::filesOfLog(path);
    return "";
  } catch (const core::Error& e) {
    return e.what();
  }
}

}  // namespace ariadne::batch
