#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <fstream>
#include <sstream>

#include "ariadne/io/dataset.h"
#include "ariadne/io/relations.h"
#include "ariadne/io/simplemap_file.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/sim/drive_path.h"
#include "ariadne/sim/world.h"
#include "dataset_info.h"
#include "evaluation.h"
#include "parts.h"
#include "rawlog_by_mrpt.h"

namespace ariadne::fuzz {
namespace {

constexpr const char* kTruth =
    "1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n3 1 1 0 0 0 0.7 0.7\n4 0 1 0 0 0 1 0\n5 0 0 0 0 0 0 1\n";

/// A path of five poses beside the file.
std::string truthBeside(const Path& file) {
  const Path truth = file.parent_path() / "truth.tum";
  if (!std::filesystem::exists(truth)) std::ofstream(truth) << kTruth;
  return truth.string();
}

}  // namespace

void readLog(const Path& file) {
  const DatasetInfo info = collectInfo(file, {}, [](double) {});
  infoAsText(info);
  infoAsJson(info);
}

/// Of a recording with a part that holds nothing.
void readMetadata(const Path& file) {
  const Path part = file.parent_path() / "part_0.mcap";
  if (!std::filesystem::exists(part)) std::ofstream(part) << "\x89MCAP0\r\n";
  readLog(file);
}

/// What is newer than our decoder: MRPT's own classes, of the versions that they write.
void readNewerObservation(const Path& file) {
  const std::string body = io::readWhole(file);
  mrpt::obs::CObservation2DRangeScan scan;
  mrpt::obs::CObservationOdometry odometry;
  io::readByMrpt(scan, {"CObservation2DRangeScan", false, io::writtenVersion(scan)}, body);
  io::readByMrpt(odometry, {"CObservationOdometry", false, io::writtenVersion(odometry)}, body);
}

void readTum(const Path& file) {
  eval_app::Arguments args;
  args.estimate = file.string();
  args.truth = truthBeside(file);
  std::ostringstream out;
  eval_app::printJson(eval_app::evaluate(args), out);
  std::swap(args.estimate, args.truth);
  eval_app::printText(args, eval_app::evaluate(args), out);
}

void readRelations(const Path& file) {
  eval_app::Arguments args;
  args.estimate = truthBeside(file);
  args.relations = file.string();
  std::ostringstream out;
  eval_app::printJson(eval_app::evaluate(args), out);
}

void readWorld(const Path& file) { sim::readWorld(file); }
/// Of a picture of 3 x 2 pixels beside it: occupied, unknown, free, twice.
void readRosMap(const Path& file) {
  const Path picture = file.parent_path() / "map.pgm";
  if (!std::filesystem::exists(picture))
    std::ofstream(picture) << std::string("P5\n3 2\n255\n\0\xcd\xfe\xfe\xcd\0", 17);
  sim::readWorld(file);
}
void readSimplemap(const Path& file) { io::readSimplemap(file); }
void readPicture(const Path& file) { sim::readWorldPicture(file, 0.05); }
void readDrive(const Path& file) {
  sim::readPath(file);
  sim::readPath(file, 3);
}

}  // namespace ariadne::fuzz
