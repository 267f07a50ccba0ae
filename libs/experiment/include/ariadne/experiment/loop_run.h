// One paired run of the paper's experiment (VI A): a recorded drive through an inner loop, mapped
// with recovery of particle diversity and without. Both arms are one run until the recovery.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>

#include "ariadne/eval/loop_errors.h"
#include "ariadne/sim/drive.h"
#include "ariadne/slam/params.h"

namespace ariadne::experiment {

/// How one arm ended.
struct ArmResult {
  std::size_t true_closures = 0;   ///< none: nothing but ate_m says anything
  bool exists = false;             ///< some particle is correct
  bool chosen = false;             ///< s* is correct
  double correct_weight = 0;       ///< of the correct particles together
  double worst_translation_m = 0;  ///< of s*, across the true loop closures
  double worst_heading_deg = 0;
  double best_translation_m = 0;  ///< least worst_translation_m of all particles
  double ate_m = 0;               ///< RMSE of s* after alignment
};

/// Of a figure that a run does not have.
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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
  double recovery_s = kNone;    ///< wall clock
  /// Change of ln Neff per 10 m travelled, resamplings taken out, until the recovery: on ground
  /// that was never driven before, once, twice, more often (eval::PassParams' defaults). NaN where
  /// the robot was on no such ground.
  double ln_neff_new_per_10m = kNone;
  double ln_neff_once_per_10m = kNone;
  double ln_neff_twice_per_10m = kNone;
  double ln_neff_more_per_10m = kNone;
};

/// Both arms of a pair, on the same drive and seed.
struct LoopRunResult {
  ArmResult recovered;
  ArmResult standard;  ///< the same as recovered where nothing was recovered
  std::optional<InnerLoop> inner;
  std::size_t closings = 0;
  std::size_t recoveries = 0;
};

/// Maps the drive as it was observed; `seed` is the filter's.
/// Same bits for the same arguments.
LoopRunResult runLoop(const sim::SimulatedDrive& seen, const slam::SlamParams& params,
                      const eval::CorrectBounds& bounds, std::uint64_t seed);

}  // namespace ariadne::experiment
