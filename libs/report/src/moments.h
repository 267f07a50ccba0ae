// Vertical lines of a chart and their names.
#pragma once
#include <vector>

#include "ariadne/report/axes.h"
#include "ariadne/report/curves.h"

namespace ariadne::report {

/// Dotted, to be drawn under the curves.
void drawMomentLines(cairo_t* cr, const Axes& axes, const std::vector<Moment>& moments);

/// Each beside its line, to be drawn over the curves.
void drawMomentNames(cairo_t* cr, const Axes& axes, const std::vector<Moment>& moments);

}  // namespace ariadne::report
