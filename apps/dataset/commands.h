// What the subcommands do, once the command line is read.
#pragma once
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>

#include "ariadne/io/dataset.h"
#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/motion_noise.h"

namespace ariadne {

struct DatasetArguments {
  std::filesystem::path in;
  std::filesystem::path out;
  io::DatasetOptions dataset;
  bool overwrite = false;
  bool json = false;
  io::CarmenLaser carmen_laser = io::CarmenLaser::robotlaser;
  io::MotionNoise noise;
  std::uint64_t seed = 1;
  double restamp_s = 0;  ///< over 0: seconds from step to step instead of the log's stamps
};

/// Each throws core::Error; results go to `out`, warnings and progress to `err`.
void showInfo(const DatasetArguments& args, std::ostream& out, std::ostream& err);
void importLog(const DatasetArguments& args, std::ostream& out, std::ostream& err);
void exportLog(const DatasetArguments& args, std::ostream& out, std::ostream& err);
void addNoise(const DatasetArguments& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
