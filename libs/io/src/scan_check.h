// Makes any scan keep StepSource's contract, or says that it cannot.
#pragma once
#include <limits>
#include <vector>

#include "ariadne/io/dataset.h"

namespace ariadne::io {

/// Whether the laser looks along the floor, upside down or not, within 5 degrees.
bool isPlanar(const mrpt::obs::CObservation2DRangeScan& scan);

/// Whether beams, angles and the laser's place are possible at all. A maximum range that is not is
/// replaced by 80 m.
bool repairGeometry(mrpt::obs::CObservation2DRangeScan& scan);

/// What of a scan is believed, m.
struct BeamLimits {
  float min_range_m = 0;  ///< nearer readings are bad
  float max_range_m = 0;  ///< over 0: in place of the scan's own maximum range
  /// Readings at or over this are no return, below the maximum range as well.
  float reach_m = std::numeric_limits<float>::infinity();
};

/// All beams at once; `valid` has 1 for those that the file calls valid.
void setBeams(mrpt::obs::CObservation2DRangeScan& scan, const std::vector<float>& ranges,
              const std::vector<char>& valid);

/// 1 for each beam that the file calls valid. MRPT checks the index at each access, which takes
/// longer than all that is done with a beam: so it is asked once.
std::vector<char> validityOf(const mrpt::obs::CObservation2DRangeScan& scan);

/// Marks bad beams as StepSource promises, and counts them. `called_valid` as validityOf() says.
void checkBeams(mrpt::obs::CObservation2DRangeScan& scan, const std::vector<char>& called_valid,
                const BeamLimits& limits, DatasetCounts& counts);

}  // namespace ariadne::io
