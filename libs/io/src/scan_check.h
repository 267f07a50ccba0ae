// Makes any scan keep StepSource's contract, or says that it cannot.
#pragma once
#include <limits>

#include "ariadne/io/dataset_records.h"

namespace ariadne::io {

/// Whether the laser looks along the floor, upside down or not, within 5 degrees.
bool isPlanar(const mrpt::obs::CObservation2DRangeScan& scan);

/// Whether beams, angles and the laser's place are possible at all. A maximum range that is not is
/// replaced by 80 m.
bool repairGeometry(LaserRecord& laser);

/// What of a scan is believed, m.
struct BeamLimits {
  float min_range_m = 0;  ///< nearer readings are bad
  float max_range_m = 0;  ///< over 0: in place of the scan's own maximum range
  /// Readings at or over this are no return, below the maximum range as well.
  float reach_m = std::numeric_limits<float>::infinity();
};

/// Gives a scan its beams, at least one, with the bad ones marked as StepSource promises, and
/// counts them.
void setBeams(mrpt::obs::CObservation2DRangeScan& scan, RawBeams beams, const BeamLimits& limits,
              DatasetCounts& counts);

}  // namespace ariadne::io
