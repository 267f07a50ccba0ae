#include "ariadne/eval/ancestor_levels.h"

namespace ariadne::eval {

using filter::Ancestor;

AncestorLevels::AncestorLevels(const std::vector<filter::AncestorPtr>& leaves) {
  int bits = 4;
  while ((std::size_t{1} << bits) < 4 * leaves.size()) ++bits;  // at most a quarter full
  slots_.resize(std::size_t{1} << bits);
  shift_ = 64 - bits;
  ++round_;
  for (const filter::AncestorPtr& leaf : leaves)
    if (leaf) meet(leaf.get());
  takeLatest();
}

void AncestorLevels::up() {
  ++round_;
  for (const Ancestor* node : frontier_) {
    const Ancestor* const next = node->step() == step_ ? node->parent().get() : node;
    if (next) meet(next);
  }
  takeLatest();
}

void AncestorLevels::meet(const Ancestor* node) {
  const auto key = reinterpret_cast<std::uintptr_t>(node);
  std::size_t at = (key * 0x9E3779B97F4A7C15U) >> shift_;  // Fibonacci hashing
  while (slots_[at].round == round_ && slots_[at].node != node) at = (at + 1) & (slots_.size() - 1);
  if (slots_[at].round == round_) return;
  slots_[at] = {node, round_};
  next_.push_back(node);
}

void AncestorLevels::takeLatest() {
  frontier_.swap(next_);
  next_.clear();
  level_.clear();
  step_ = 0;
  for (const Ancestor* node : frontier_) {
    const std::size_t step = node->step();
    if (step < step_) continue;
    if (step > step_) level_.clear();
    step_ = step;
    level_.push_back(node);
  }
}

}  // namespace ariadne::eval
