// A picture of the errors: the trajectory over the truth, coloured by error, and the error over
// time.
#pragma once
#include <string>

#include "evaluation.h"

namespace ariadne::eval_app {

/// PNG or SVG by the extension. Throws core::UsageError for another, core::Error naming the file.
void writeErrorPlot(const std::string& file, const TruthResult& result, bool overwrite);

/// Throws core::UsageError when the plot cannot be meant, core::Error when the file exists and is
/// not to be overwritten.
void checkPlotFile(const std::string& file, bool overwrite);

}  // namespace ariadne::eval_app
