#include "ariadne/filter/resampling.h"

#include <mrpt/bayes/CParticleFilterCapable.h>
#include <mrpt/random/RandomGenerators.h>

#include <algorithm>
#include <cmath>

namespace ariadne::filter {
namespace {

using mrpt::bayes::CParticleFilter;
using mrpt::bayes::CParticleFilterCapable;

CParticleFilter::TParticleResamplingAlgorithm mrptMethod(Resampling method) {
  switch (method) {
    case Resampling::multinomial:
      return CParticleFilter::prMultinomial;
    case Resampling::stratified:
      return CParticleFilter::prStratified;
    case Resampling::systematic:
      return CParticleFilter::prSystematic;
    case Resampling::residual:
      break;
  }
  return CParticleFilter::prResidual;
}

}  // namespace

std::vector<std::size_t> drawByWeight(Resampling method, const std::vector<double>& log_weights,
                                      core::RandomStream& rng) {
  std::vector<std::size_t> indices;
  if (method == Resampling::residual) {
    std::vector<double> weights;
    CParticleFilterCapable::log2linearWeights(log_weights, weights);
    return residualIndices(weights, rng);
  }
  // MRPT draws from its generator, of which every thread has its own: the one place where it is
  // seeded.
  mrpt::random::getRandomGenerator().randomize(rng.bits());
  CParticleFilterCapable::computeResampling(mrptMethod(method), log_weights, indices);
  return indices;
}

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
