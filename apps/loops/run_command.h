// `run`: a row of figures for each seed.
#pragma once
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "ariadne/experiment/loop_config.h"

namespace ariadne::loops_app {

struct Seeds {
  std::uint64_t first = 1;
  std::uint64_t last = 10;
};

/// Adds to the CSV file what is not in it: paired runs, or with `oracle` the first loop next to one
/// filter a particle. Says on `err` how each came out. Throws core::Error when a run with the
/// oracle recovers no loop.
void runSeeds(const experiment::LoopConfig& config, std::optional<int> laps, const Seeds& seeds,
              bool oracle, const std::string& file, std::ostream& err);

}  // namespace ariadne::loops_app
