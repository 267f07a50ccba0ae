#include "ariadne/eval/neff.h"

#include "ariadne/geometry/weighted_poses.h"

namespace ariadne::eval {

double neff(const std::vector<double>& weights) {
  geometry::checkWeights(weights);
  double squares = 0;
  for (const double w : weights) squares += w * w;
  return 1 / squares;
}

}  // namespace ariadne::eval
