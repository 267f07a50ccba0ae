// An arm's runs next to those of the experiment's first arm on the same seeds.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/tables.h"

namespace ariadne::batch {

/// Of one cell: seed to result.
using Runs = std::map<std::uint64_t, const RunResult*>;

bool isFinished(const RunResult* r);

/// What the arm's program calls the figure that success is judged by.
Success successOf(const Plan& plan, std::size_t arm);

/// @param first runs of the experiment's first arm
Pairs pairsOf(const Plan& plan, const Runs& first, const Runs& runs, std::size_t arm);

/// See Cell::changes.
std::vector<std::vector<double>> changesOf(const Plan& plan, const Runs& first, const Runs& runs,
                                           std::size_t arm);

}  // namespace ariadne::batch
