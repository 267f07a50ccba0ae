#include "run_command.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/drives.h"
#include "ariadne/experiment/oracle_rows.h"
#include "ariadne/experiment/run_rows.h"
#include "row_file.h"

namespace ariadne::loops_app {
namespace {

using experiment::Drives;
using experiment::LoopConfig;

/// A run's row, and what the user is told.
struct Row {
  std::string cells;
  std::string told;
};

Row pairOf(const LoopConfig& config, const Drives& drives, std::uint64_t seed) {
  const auto r = experiment::runLoop(drives.observe(seed), config.slam, config.correct, seed);
  return {experiment::toLine({drives.name(), drives.laps(), seed, r}),
          fmt::format("recovery {:.2f} m, standard {:.2f} m", r.recovered.worst_translation_m,
                      r.standard.worst_translation_m)};
}

Row oracleOf(const LoopConfig& config, const Drives& drives, std::uint64_t seed) {
  const auto r = experiment::runOracle(drives.observe(seed), config.slam, config.correct, seed);
  if (!r) throw core::Error(fmt::format("seed {}: no loop was recovered", seed));
  return {experiment::oracleLine(drives.name(), drives.laps(), seed, *r),
          fmt::format("KL from the oracle's set: recovery {:.2f}, standard {:.2f} nats",
                      r->kl_recovered_nats, r->kl_standard_nats)};
}

}  // namespace

void runSeeds(const LoopConfig& config, std::optional<int> laps, const Seeds& seeds, bool oracle,
              const std::string& file, std::ostream& err) {
  if (seeds.last < seeds.first) throw core::UsageError("--last is before --first");
  RowFile rows(file, oracle ? experiment::oracleHeader() : experiment::rowsHeader());
  const Drives drives(config, laps);
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    if (rows.has(fmt::format("{},{},{}", drives.name(), drives.laps(), seed))) continue;
    const Row row = oracle ? oracleOf(config, drives, seed) : pairOf(config, drives, seed);
    rows.add(row.cells);
    fmt::print(err, "{}, {} laps, seed {} of {}: {}\n", drives.name(), drives.laps(), seed,
               seeds.last, row.told);
  }
}

}  // namespace ariadne::loops_app
