// Which slices of a plan are to be handed out.
#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/store.h"

namespace ariadne::cluster {

/// The slice-th of `slices`, from 1.
struct Slice {
  std::size_t slice = 1;
  std::size_t slices = 1;
  bool waits = false;  ///< its task has not begun
};

/// Of `slices`, those with a run that has no result and is in none of `active`, in order.
/// @param again keys of runs whose results were dropped just now: tasks that have begun are past
/// them, those that wait will do them
std::vector<std::size_t> openSlices(const batch::Plan& plan, const batch::Store& store,
                                    std::size_t slices, const std::vector<Slice>& active,
                                    const std::set<std::string>& again = {});

/// "1-4,7,9-12", as sbatch takes it; of rising numbers.
std::string rangesText(const std::vector<std::size_t>& numbers);

}  // namespace ariadne::cluster
