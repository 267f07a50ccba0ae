#include "ariadne/experiment/oracle_rows.h"

#include <fmt/format.h>

namespace ariadne::experiment {
namespace {

constexpr const char* kFigures[] = {"exists", "chosen", "translation_m", "ate_m", "kl_nats"};

std::string cellsOf(const ArmResult& arm) {
  return fmt::format(",{:d},{:d},{},{}", arm.exists, arm.chosen, arm.worst_translation_m,
                     arm.ate_m);
}

}  // namespace

std::string oracleHeader() {
  std::string line = "name,laps,seed";
  for (const char* arm : {"oracle", "recovered", "standard"})
    for (const char* figure : kFigures) line += fmt::format(",{}_{}", arm, figure);
  return line;
}

std::string oracleLine(const std::string& name, int laps, std::uint64_t seed,
                       const OracleResult& r) {
  std::string line = fmt::format("{},{},{}", name, laps, seed);
  line += cellsOf(r.oracle) + ",";
  line += cellsOf(r.recovered) + fmt::format(",{}", r.kl_recovered_nats);
  return line + cellsOf(r.standard) + fmt::format(",{}", r.kl_standard_nats);
}

}  // namespace ariadne::experiment
