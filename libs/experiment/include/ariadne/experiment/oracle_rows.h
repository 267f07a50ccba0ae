// Results next to the oracle as lines of a CSV file.
#pragma once
#include <cstdint>
#include <string>

#include "ariadne/experiment/oracle.h"

namespace ariadne::experiment {

/// Without line ends. The oracle has no KL: the others' is from its set.
std::string oracleHeader();
std::string oracleLine(const std::string& name, int laps, std::uint64_t seed,
                       const OracleResult& result);

}  // namespace ariadne::experiment
