#include "ariadne/eval/ancestor_levels.h"

#include "ariadne/geometry/weighted_poses.h"

namespace ariadne::eval {

using filter::Ancestor;

AncestorLevels::AncestorLevels(const std::vector<filter::AncestorPtr>& leaves,
                               const std::vector<double>& weights) {
  if (!weights.empty()) geometry::checkCounts(weights.size(), leaves.size(), "particles");
  int bits = 4;
  while ((std::size_t{1} << bits) < 4 * leaves.size()) ++bits;  // at most a quarter full
  slots_.resize(std::size_t{1} << bits);
  shift_ = 64 - bits;
  ++round_;
  for (std::size_t i = 0; i < leaves.size(); ++i)
    if (leaves[i]) meet(leaves[i].get(), weights.empty() ? 0 : weights[i]);
  takeLatest();
}

void AncestorLevels::up() {
  ++round_;
  for (const Entry& e : frontier_) {
    const Ancestor* const node = e.node->step() == step_ ? e.node->parent().get() : e.node;
    if (node) meet(node, e.weight);
  }
  takeLatest();
}

void AncestorLevels::meet(const Ancestor* node, double weight) {
  const auto key = reinterpret_cast<std::uintptr_t>(node);
  std::size_t at = (key * 0x9E3779B97F4A7C15U) >> shift_;  // Fibonacci hashing
  while (slots_[at].round == round_ && slots_[at].node != node) at = (at + 1) & (slots_.size() - 1);
  if (slots_[at].round == round_) {
    next_[slots_[at].index].weight += weight;
    return;
  }
  slots_[at] = {node, round_, static_cast<std::uint32_t>(next_.size())};
  next_.push_back({node, weight});
}

void AncestorLevels::takeLatest() {
  frontier_.swap(next_);
  next_.clear();
  level_.clear();
  step_ = 0;
  for (const Entry& e : frontier_) {
    const std::size_t step = e.node->step();
    if (step < step_) continue;
    if (step > step_) level_.clear();
    step_ = step;
    level_.push_back(e);
  }
}

}  // namespace ariadne::eval
