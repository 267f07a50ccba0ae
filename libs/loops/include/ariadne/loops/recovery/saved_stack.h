// Saved sets of the loops that are being closed at once, section V: nested loops of a robot that
// somebody else drives need more than one.
#pragma once
#include <optional>
#include <vector>

#include "ariadne/loops/recovery/saved_set.h"

namespace ariadne::loops {

/// Saved sets of nested loops, the innermost on top, within a budget of memory.
class SavedStack {
 public:
  /// @param budget_mb of the maps of all sets; where it is exceeded, the oldest set is dropped
  explicit SavedStack(double budget_mb) : budget_mb_(budget_mb) {}

  /// Lays a set on top, under an id of the caller's. Returns the ids of the sets that were
  /// dropped to stay within the budget, oldest first; the new one is among them when it alone is
  /// too big.
  std::vector<std::size_t> push(std::size_t id, SavedSet set);
  /// Takes a set out and drops what lies above it; nothing when it is not there (any more).
  std::optional<SavedSet> pop(std::size_t id);
  /// Takes one set out and leaves the others.
  void drop(std::size_t id);

  /// Takes out the sets whose te lies after `step`.
  void dropAfter(std::size_t step);

  /// Whether the set with this id is still there.
  bool holds(std::size_t id) const;
  /// Number of sets.
  std::size_t size() const { return sets_.size(); }
  /// Memory of all maps held, tiles counted once, MB.
  double megabytes() const;

 private:
  struct Entry {
    std::size_t id;
    SavedSet set;
  };
  std::vector<Entry>::iterator find(std::size_t id);

  double budget_mb_;
  std::vector<Entry> sets_;
};

}  // namespace ariadne::loops
