// Makes any scan keep StepSource's contract, or says that it cannot.
#pragma once
#include "ariadne/io/dataset.h"

namespace ariadne::io {

/// Whether the laser looks along the floor, upside down or not, within 5 degrees.
bool isPlanar(const mrpt::obs::CObservation2DRangeScan& scan);

/// Whether beams, angles and the laser's place are possible at all. A maximum range that is not is
/// replaced by 80 m.
bool repairGeometry(mrpt::obs::CObservation2DRangeScan& scan);

/// Marks bad beams as StepSource promises, and counts them.
void checkBeams(mrpt::obs::CObservation2DRangeScan& scan, DatasetCounts& counts);

}  // namespace ariadne::io
