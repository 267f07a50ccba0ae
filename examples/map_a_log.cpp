// Maps a log with the library: example-map-a-log LOG FOLDER
#include <filesystem>
#include <iostream>

#include "ariadne/io/dataset.h"
#include "ariadne/io/map_files.h"
#include "ariadne/io/tum.h"
#include "ariadne/slam/mapper.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: example-map-a-log LOG FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[2];
  try {
    // Any log that ariadne-slam takes. On a robot the steps come from its drivers instead:
    // a time, the odometry's pose and the scan.
    const auto log = ariadne::io::openDataset(argv[1]);

    ariadne::slam::SlamParams params;  // the defaults; each member is a section of the INI
    params.filter.particles = 20;
    ariadne::slam::Mapper mapper(params, /*threads=*/0);

    while (const auto step = log->next()) {
      const auto report = mapper.process(*step);  // nothing, until the robot has moved far enough
      if (report && report->resampled)
        std::cout << "update " << report->step << ": Neff " << report->neff << ", resampled\n";
    }

    std::filesystem::create_directories(folder);
    ariadne::io::writeRosMap(folder / "map.pgm", mapper.map());  // and map.yaml
    ariadne::io::writeTum(folder / "trajectory.tum", mapper.path());
    std::cout << mapper.updates() << " updates; the map is " << (folder / "map.yaml").string()
              << '\n';
  } catch (const std::exception& e) {  // core::Error says what is wrong with the log
    std::cerr << "example-map-a-log: " << e.what() << '\n';
    return 1;
  }
}
