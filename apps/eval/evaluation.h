// What ariadne-eval computes from its files, and how it is shown.
#pragma once
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "ariadne/eval/errors.h"

namespace ariadne::eval_app {

struct Arguments {
  std::string estimate;
  std::string truth;      ///< empty: none
  std::string relations;  ///< empty: none
  std::string plot;       ///< empty: none
  double max_gap_s = 1;
  double delta_m = 1;
  bool json = false;
  bool overwrite = false;
};

struct TruthResult {
  std::size_t truth_poses = 0;
  std::vector<eval::PosePair> pairs;
  mrpt::math::TPose2D truth_from_estimate;
  std::vector<double> distances_m;  ///< one a pair
  eval::ErrorFigures absolute_m;
  eval::ErrorFigures heading_deg;
  eval::ErrorFigures relative_m;
  eval::ErrorFigures relative_deg;
  std::size_t closures = 0;            ///< true loop closures, those without an estimate too
  std::size_t unmatched_closures = 0;  ///< for which the estimate has no pose
  eval::ErrorFigures closure_m;        ///< across those that have; zeros where there is none
  eval::ErrorFigures closure_deg;
};

struct RelationResult {
  std::size_t unmatched = 0;
  eval::ErrorFigures translation_m;
  eval::ErrorFigures rotation_deg;
};

struct Evaluation {
  std::size_t estimated_poses = 0;
  std::optional<TruthResult> truth;
  std::optional<RelationResult> relations;
};

/// Throws core::Error naming the file, also when the files have no time in common.
Evaluation evaluate(const Arguments& args);

void printText(const Arguments& args, const Evaluation& e, std::ostream& out);
void printJson(const Evaluation& e, std::ostream& out);

}  // namespace ariadne::eval_app
