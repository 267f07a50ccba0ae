// One paired run of the paper's experiment (VI A): a recorded drive through an inner loop, mapped
// with recovery of particle diversity and without. Both arms are one run until the recovery.
#pragma once
#include <cstdint>
#include <optional>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/sim/drive.h"
#include "ariadne/slam/params.h"

namespace ariadne::experiment {

/// How one arm ended.
struct ArmResult {
  bool exists = false;             ///< some particle is correct
  bool chosen = false;             ///< s* is correct
  double correct_weight = 0;       ///< of the correct particles together
  double worst_translation_m = 0;  ///< of s*, across the true loop closures
  double worst_heading_deg = 0;
  double best_translation_m = 0;  ///< least worst_translation_m of all particles
  double ate_m = 0;               ///< RMSE of s* after alignment
};

/// What was lost where, at the recovery of the inner loop: the least error of the pose at te seen
/// from the start (m) in the set that there was at te, in what was saved at the detection, and in
/// what was left when the robot left the loop.
struct InnerLoop {
  double existed_error_m = 0;
  double saved_error_m = 0;
  double left_error_m = 0;
  double survivors = 0;            ///< distinct saved over distinct that existed at te
  std::size_t distinct_left = 0;   ///< of the saved ancestors at te, before recovery
  std::size_t distinct_saved = 0;  ///< and after it
  double kl_saved_nats = 0;        ///< KL(true at te || saved), eval::KernelParams' defaults
  double kl_left_nats = 0;         ///< KL(true at te || set before recovery as of te)
  double lost_mass = 0;
  double neff_slope_per_m = 0;  ///< of ln Neff within the closing, resamplings apart
  double resamplings = 0;       ///< within the closing
  double recovery_s = 0;
};

struct LoopRunResult {
  ArmResult recovered;
  ArmResult standard;  ///< the same as recovered where nothing was recovered
  std::optional<InnerLoop> inner;
  std::size_t closings = 0;
  std::size_t recoveries = 0;
};

/// Maps the drive as it is observed with this seed; the filter has the same seed.
/// Same bits for the same arguments.
LoopRunResult runLoop(const sim::TruthDrive& drive, const sim::NoiseParams& noise,
                      const slam::SlamParams& params, const eval::CorrectBounds& bounds,
                      std::uint64_t seed);

}  // namespace ariadne::experiment
