#include "ariadne/filter/residual.h"

#include <algorithm>
#include <cmath>

namespace ariadne::filter {

std::vector<std::size_t> residualIndices(const std::vector<double>& weights,
                                         core::RandomStream& rng) {
  const std::size_t n = weights.size();
  std::vector<std::size_t> indices;
  std::vector<double> cumulated;  // of the remainders
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double expected = static_cast<double>(n) * weights[i];
    const double whole = std::floor(expected);
    indices.insert(indices.end(), static_cast<std::size_t>(whole), i);
    cumulated.push_back(sum += expected - whole);
  }
  while (indices.size() < n) {
    const auto it = std::upper_bound(cumulated.begin(), cumulated.end(), sum * rng.uniform());
    indices.push_back(std::min<std::size_t>(it - cumulated.begin(), n - 1));
  }
  indices.resize(n);  // rounding may give one too many
  std::sort(indices.begin(), indices.end());
  return indices;
}

}  // namespace ariadne::filter
