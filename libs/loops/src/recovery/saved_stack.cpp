#include "ariadne/loops/recovery/saved_stack.h"

#include <algorithm>

namespace ariadne::loops {

std::vector<SavedStack::Entry>::iterator SavedStack::find(std::size_t id) {
  return std::find_if(sets_.begin(), sets_.end(), [&](const Entry& n) { return n.id == id; });
}

std::vector<std::size_t> SavedStack::push(std::size_t id, SavedSet set) {
  sets_.push_back({id, std::move(set)});
  std::vector<std::size_t> dropped;
  while (!sets_.empty() && megabytes() > budget_mb_) {
    dropped.push_back(sets_.front().id);
    sets_.erase(sets_.begin());
  }
  return dropped;
}

std::optional<SavedSet> SavedStack::pop(std::size_t id) {
  const auto it = find(id);
  if (it == sets_.end()) return std::nullopt;
  SavedSet set = std::move(it->set);
  sets_.erase(it, sets_.end());
  return set;
}

void SavedStack::drop(std::size_t id) {
  const auto it = find(id);
  if (it != sets_.end()) sets_.erase(it);
}

void SavedStack::dropAfter(std::size_t step) {
  sets_.erase(
      std::remove_if(sets_.begin(), sets_.end(), [&](const Entry& n) { return n.set.te > step; }),
      sets_.end());
}

bool SavedStack::holds(std::size_t id) const {
  return std::any_of(sets_.begin(), sets_.end(), [&](const Entry& n) { return n.id == id; });
}

double SavedStack::megabytes() const {
  SavedSet all;
  for (const Entry& n : sets_)
    all.entries.insert(all.entries.end(), n.set.entries.begin(), n.set.entries.end());
  return static_cast<double>(all.mapBytes()) / 1e6;
}

}  // namespace ariadne::loops
