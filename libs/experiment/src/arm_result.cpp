#include "arm_result.h"

#include <algorithm>
#include <limits>

#include "ariadne/eval/alignment.h"
#include "ariadne/eval/errors.h"

namespace ariadne::experiment {
namespace {

double ateOf(const geometry::Trajectory& path, const geometry::Trajectory& truth) {
  const auto pairs = eval::associate(path, truth, 0);
  return eval::figuresOf(eval::absoluteErrors(pairs, eval::align(pairs))).rmse;
}

}  // namespace

ArmResult armResultOf(const slam::Mapper& mapper, const geometry::Trajectory& truth,
                      const eval::CorrectBounds& bounds) {
  ArmResult arm;
  const std::vector<double> weights = mapper.particles().weights();
  const std::size_t best = mapper.particles().best();
  arm.best_translation_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mapper.particles().size(); ++i) {
    const geometry::Trajectory path = mapper.pathOf(i);
    const eval::LoopErrors errors = eval::loopErrors(path, truth, 0);
    const bool right = eval::verdictOf(errors, bounds) == eval::Verdict::correct;
    arm.exists |= right;
    arm.correct_weight += right ? weights[i] : 0;
    arm.best_translation_m =
        std::min(arm.best_translation_m, errors.worst_translation.translation_m);
    if (i != best) continue;
    arm.true_closures = errors.closures.size() + errors.unmatched;
    arm.chosen = right;
    arm.worst_translation_m = errors.worst_translation.translation_m;
    arm.worst_heading_deg = errors.worst_heading.heading_deg;
    arm.ate_m = ateOf(path, truth);
  }
  return arm;
}

}  // namespace ariadne::experiment
