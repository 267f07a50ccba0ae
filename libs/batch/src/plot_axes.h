// A plot's axes in gnuplot's language.
#pragma once
#include <string>

#include "ariadne/batch/plot_data.h"

namespace ariadne::batch {

/// Numbers are drawn upright with lines between them; names lie, so that long ones have room.
bool isUpright(const Plot& plot);

/// Pixels, as all lengths here.
int widthOf(const Plot& plot);

/// Labels, ticks, ranges and, of a plot that lies, the left margin.
std::string axesOf(const Plot& plot);

}  // namespace ariadne::batch
