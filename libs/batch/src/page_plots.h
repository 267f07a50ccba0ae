// The plots of an experiment's page.
#pragma once
#include <string>
#include <vector>

#include "ariadne/batch/plots.h"

namespace ariadne::batch {

/// Each plot with its numbers. @param pictures of the plots, or none
std::string plotsHtml(const std::vector<Plot>& plots, const std::vector<Picture>& pictures);

}  // namespace ariadne::batch
