// What ariadne-stock-rbpf writes, so that it can be compared with ariadne-slam's.
#pragma once
#include <string>

#include "stock_mapping.h"

namespace ariadne::stock_app {

/// Names of files; empty: not written.
struct OutputFiles {
  std::string trajectory;
  std::string path;
  std::string overview;
  std::string summary;
};

/// Throws core::Error naming the file; also for an overview where the INI asks for no grid.
void writeOutputs(const OutputFiles& files, const StockRun& run,
                  mrpt::slam::CMetricMapBuilderRBPF& builder);

/// One line of counts, CPU time and peak memory until now, on the standard output.
void printCosts(const StockRun& run, mrpt::slam::CMetricMapBuilderRBPF& builder);

}  // namespace ariadne::stock_app
