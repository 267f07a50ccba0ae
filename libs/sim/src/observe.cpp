#include "ariadne/sim/drive.h"
#include "ariadne/sim/senses.h"

namespace ariadne::sim {

SimulatedDrive observe(const TruthDrive& drive, const NoiseParams& noise, std::uint64_t seed) {
  Senses senses(noise, seed);
  SimulatedDrive out;
  out.truth = drive.poses;
  out.marks = drive.marks;
  out.steps.reserve(drive.poses.size());
  for (std::size_t k = 0; k < drive.poses.size(); ++k)
    out.steps.push_back(senses.next(drive.poses[k], *drive.scans[k]));
  return out;
}

}  // namespace ariadne::sim
