// Was every true loop closed? The error of the estimate across each place where the true path comes
// back to itself. No alignment is needed: a motion between two moments is compared.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/core/fields.h"
#include "ariadne/geometry/trajectory.h"

namespace ariadne::eval {

/// Which pairs of true poses are a loop closure: near each other, with a long path between.
struct LoopParams {
  double near_m = 2;
  double apart_m = 10;
  double every_m = 1;
};

template <class V>
void visitFields(V& v, LoopParams& p) {
  v.number("near_m", p.near_m, {0.01, 100},
           "two moments close a loop when their true positions are nearer than this");
  v.number("apart_m", p.apart_m, {0.01, 100000}, "and the true path between them is longer");
  v.number("every_m", p.every_m, {0.01, 100}, "true path between the moments that are looked at");
}

/// When a run counts as correct: bounds on the error across every true closure.
struct CorrectBounds {
  double translation_m = 0.5;
  double heading_deg = 5;
};

template <class V>
void visitFields(V& v, CorrectBounds& p) {
  v.number("translation_m", p.translation_m, {0, 1000},
           "largest error of position across a true loop closure in a correct run");
  v.number("heading_deg", p.heading_deg, {0, 180},
           "largest error of heading across a true loop closure in a correct run");
}

/// The error of one relative pose across a loop.
struct LoopError {
  std::size_t first = 0;     ///< index in the truth
  std::size_t second = 0;    ///< later index in the truth
  double translation_m = 0;  ///< length of (estimated motion)^-1 (true motion), first to second
  double heading_deg = 0;    ///< its turn, 0 to 180
};

/// All closures of a path and what they sum up to.
struct LoopErrors {
  std::vector<LoopError> closures;  ///< by second, then by first; empty when no loop is there
  std::size_t unmatched = 0;        ///< true closures for which the estimate has no pose
  LoopError worst_translation;      ///< zeros without a closure, here and below
  LoopError worst_heading;
  double median_translation_m = 0;
  double median_heading_deg = 0;
};

/// All pairs (i < j) of true moments, one about every `every_m` of true path, that are near in
/// space and apart along the path. Time grows with the pairs near in space. The estimate is taken
/// at the truth's stamps as poseAt() does, so it may be in any frame.
/// @param truth in time order, map frame
/// @param max_gap_s as in associate(); 0 for equal stamps only
/// Throws core::UsageError for parameters out of bounds, or unless near_m < apart_m.
LoopErrors loopErrors(const geometry::Trajectory& estimate, const geometry::Trajectory& truth,
                      double max_gap_s, const LoopParams& params = {});

/// What the true loop closures say of a run.
enum class Verdict {
  correct,  ///< none is unmatched and none is over a bound
  wrong,
  no_loop  ///< the true path has none: nothing to judge the run by
};

/// "correct", "wrong", "no_loop".
const char* nameOf(Verdict verdict);

/// Throws core::UsageError for bounds that are out of theirs.
Verdict verdictOf(const LoopErrors& errors, const CorrectBounds& bounds = {});

}  // namespace ariadne::eval
