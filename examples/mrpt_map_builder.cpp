// How a program for MRPT's mapper takes Ariadne: the two lines marked "was" are all that changed.
// Try it: example-mrpt-map-builder STOCK.ini LOG.rawlog map.simplemap, with an INI from
// /usr/share/mrpt/config_files/rbpf-slam.
#include <mrpt/config/CConfigFile.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <iostream>

#include "ariadne/slam/rbpf_map_builder.h"  // was: <mrpt/slam/CMetricMapBuilderRBPF.h>

using MapBuilder = ariadne::slam::RbpfMapBuilder;  // was: mrpt::slam::CMetricMapBuilderRBPF

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: example-mrpt-map-builder STOCK.ini LOG.rawlog OUT.simplemap\n"
                 "Maps an action-observation rawlog as programs for CMetricMapBuilderRBPF do.\n";
    return 2;
  }
  try {
    MapBuilder::TConstructionOptions options;
    options.loadFromConfigFile(mrpt::config::CConfigFile(argv[1]), "MappingApplication");
    options.verbosity_level = mrpt::system::LVL_WARN;
    MapBuilder builder(options);

    mrpt::obs::CRawlog log;
    if (!log.loadFromRawLogFile(argv[2]))
      throw std::runtime_error(std::string("cannot read ") + argv[2]);
    mrpt::obs::CActionCollection::Ptr action;
    mrpt::obs::CSensoryFrame::Ptr observations;
    std::size_t inserted = 0;
    for (std::size_t entry = 0;
         entry + 1 < log.size() && log.getActionObservationPair(action, observations, entry);) {
      builder.processActionObservation(*action, *observations);
      inserted += builder.m_statsLastIteration.observationsInserted;
    }
    const auto [covariance, pose] = builder.getCurrentPoseEstimation()->getCovarianceAndMean();
    std::cout << inserted << " scans in the map; the robot is at " << pose.asString() << '\n';
    builder.saveCurrentMapToFile(argv[3]);
    std::cout << "scans and poses for MRPT: " << argv[3] << '\n';
  } catch (const std::exception& e) {
    std::cerr << "example-mrpt-map-builder: " << e.what() << '\n';
    return 1;
  }
}
