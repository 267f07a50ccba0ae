#include "cell_pairs.h"

#include <cmath>
#include <optional>

#include "ariadne/statistics/exact_tests.h"

namespace ariadne::batch {
namespace {

std::optional<double> figureOf(const Plan& plan, const RunResult& result, std::size_t arm,
                               const std::string& name) {
  return valueOf(result.figures, plan.arms[arm].prefix + name);
}

}  // namespace

bool isFinished(const RunResult* r) { return r->failure.empty(); }

Success successOf(const Plan& plan, std::size_t arm) {
  Success success = plan.success;
  success.figure = plan.arms[arm].prefix + success.figure;
  return success;
}

Pairs pairsOf(const Plan& plan, const Runs& first, const Runs& runs, std::size_t arm) {
  Pairs pairs;
  for (const auto& [seed, result] : runs) {
    const auto other = first.find(seed);
    if (other == first.end() || !isFinished(result) || !isFinished(other->second)) continue;
    const Judgement this_one = successOf(plan, arm).of(result->figures);
    const Judgement first_one = successOf(plan, 0).of(other->second->figures);
    pairs.only_first += first_one == Judgement::success && this_one == Judgement::no_success;
    pairs.only_this += this_one == Judgement::success && first_one == Judgement::no_success;
  }
  pairs.p = statistics::mcnemarTest(pairs.only_first, pairs.only_this);
  return pairs;
}

std::vector<std::vector<double>> changesOf(const Plan& plan, const Runs& first, const Runs& runs,
                                           std::size_t arm) {
  std::vector<std::vector<double>> changes(plan.relative.size());
  for (const auto& [seed, result] : runs) {
    const auto other = first.find(seed);
    if (other == first.end() || !isFinished(result) || !isFinished(other->second)) continue;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const auto from = figureOf(plan, *other->second, 0, plan.relative[i]);
      const auto to = figureOf(plan, *result, arm, plan.relative[i]);
      if (from && to && *from != 0) changes[i].push_back(100 * (*to - *from) / std::abs(*from));
    }
  }
  return changes;
}

}  // namespace ariadne::batch
