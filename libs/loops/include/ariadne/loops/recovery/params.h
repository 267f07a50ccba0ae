// Parameters of saving and recovering particle diversity.
#pragma once
#include "ariadne/core/fields.h"

namespace ariadne::loops {

/// Whose path through the loop a saved hypothesis is given.
enum class Draw { independent, shared, own_descendant_first };

/// Section [recovery]; each key is explained in visitFields.
struct RecoveryParams {
  bool enabled = true;
  Draw draw = Draw::independent;
  double memory_budget_mb = 1000;
};

template <class V>
void visitFields(V& v, RecoveryParams& p) {
  v.flag("enabled", p.enabled, "recover the hypotheses of the entry when a closing ends");
  v.choice(
      "draw", p.draw,
      core::Choices<Draw>{{"independent", Draw::independent},
                          {"shared", Draw::shared},
                          {"own_descendant_first", Draw::own_descendant_first}},
      "path through the loop that a saved hypothesis gets: one drawn by weight for each; one for "
      "all; that of an own descendant where one is left");
  v.number(
      "memory_budget_mb", p.memory_budget_mb, {1, 1e6},
      "maps of all saved sets, what they share counted once; when they take more the oldest set is "
      "dropped");
}

}  // namespace ariadne::loops
