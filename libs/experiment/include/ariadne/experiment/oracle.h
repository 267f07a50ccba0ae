// The oracle of Section V, second paragraph: if one knew the entry of a loop beforehand, the filter
// would be suspended there, one filter of its own started for each particle, and each one's
// solution attached to its particle. Exact for one loop, N filters dear: what the recovery is
// measured by.
#pragma once
#include <cstdint>
#include <optional>

#include "ariadne/experiment/loop_run.h"

namespace ariadne::experiment {

/// A run with a filter of its own for every particle through the loop (the paper's Section V),
/// beside recovery.
struct OracleResult {
  ArmResult oracle;
  ArmResult recovered;
  ArmResult standard;
  /// Of the sets at the end of the closing, positions: KL(oracle's || recovered), and of what the
  /// standard filter had left; nats, eval::KernelParams' defaults.
  double kl_recovered_nats = 0;
  double kl_standard_nats = 0;
};

/// The first loop of the drive that is recovered; nothing when there is none. The filter has N
/// particles, so has each of the N filters.
std::optional<OracleResult> runOracle(const sim::SimulatedDrive& seen,
                                      const slam::SlamParams& params,
                                      const eval::CorrectBounds& bounds, std::uint64_t seed);

}  // namespace ariadne::experiment
