#include "ariadne/eval/errors.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/pose.h"

namespace ariadne::eval {

using mrpt::math::TPose2D;

ErrorFigures figuresOf(std::vector<double> errors) {
  ErrorFigures f;
  f.count = errors.size();
  if (errors.empty()) return f;
  const auto n = static_cast<double>(errors.size());
  double squares = 0;
  for (const double e : errors) {
    f.mean += e / n;
    squares += e * e / n;
    f.max = std::max(f.max, e);
  }
  f.rmse = std::sqrt(squares);
  for (const double e : errors) f.deviation += (e - f.mean) * (e - f.mean) / n;
  f.deviation = std::sqrt(f.deviation);
  std::sort(errors.begin(), errors.end());
  f.median = (errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2;
  return f;
}

std::vector<double> absoluteErrors(const std::vector<PosePair>& pairs,
                                   const TPose2D& truth_from_estimate) {
  std::vector<double> errors;
  for (const auto& p : pairs) {
    const TPose2D laid = geometry::compose(truth_from_estimate, p.estimate);
    errors.push_back(geometry::distance(laid, p.truth));
  }
  return errors;
}

RelativeErrors relativeErrors(const std::vector<PosePair>& pairs, double delta_m) {
  std::vector<double> travelled(pairs.size(), 0);
  for (std::size_t i = 1; i < pairs.size(); ++i)
    travelled[i] = travelled[i - 1] + geometry::distance(pairs[i].truth, pairs[i - 1].truth);
  RelativeErrors errors;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto end = std::lower_bound(travelled.begin() + static_cast<std::ptrdiff_t>(i),
                                      travelled.end(), travelled[i] + delta_m);
    if (end == travelled.end() || end == travelled.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    const auto& later = pairs[static_cast<std::size_t>(end - travelled.begin())];
    const TPose2D error =
        geometry::relativePose(geometry::relativePose(pairs[i].estimate, later.estimate),
                               geometry::relativePose(pairs[i].truth, later.truth));
    errors.translation_m.push_back(std::hypot(error.x, error.y));
    errors.rotation_deg.push_back(std::abs(error.phi) * 180 / M_PI);
  }
  return errors;
}

}  // namespace ariadne::eval
