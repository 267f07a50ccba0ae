// All runs of an experiment: for every seed, combination of the factors' values, and arm, one.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/experiment.h"
#include "ariadne/batch/program.h"

namespace ariadne::batch {

/// An arm whose program was found.
struct PlannedArm {
  std::string name;
  std::string prefix;  ///< see Arm
  Program program;
  std::string truth;  ///< path, or empty
};

/// One run: an arm, the factors' values and a seed.
struct PlannedRun {
  std::uint64_t seed = 0;
  std::vector<std::string> values;  ///< of the factors, in their order
  std::size_t arm = 0;              ///< in Plan::arms
  /// Hash of all that makes the result: program, resolved INI, data, arguments, seed. Two arms that
  /// ask the same of a program share a run.
  std::string key;
  std::string config;  ///< in Plan::configs
  std::vector<std::string> arguments;
};

/// Enough for any machine that sees the results folder to do any of the runs.
struct Plan {
  std::string title;
  std::string ini;  ///< text of the experiment's INI
  std::vector<std::string> factors;
  std::vector<PlannedArm> arms;
  std::vector<std::string> figures;
  std::vector<std::string> relative;  ///< see Experiment
  Success success;
  PlotChoice plots;
  Limits limits;
  std::vector<PlannedRun> runs;
  std::map<std::string, std::string> configs;  ///< by hash: the arms' resolved INIs
  std::map<std::string, std::string> files;    ///< programs and data, and the hash each must have
};

/// "seed 3, laps 10, frontier".
std::string describe(const Plan& plan, const PlannedRun& run);

/// Each run once, in the plan's order: the i-th of them (from 0) is in slice i % n + 1 of n.
std::vector<const PlannedRun*> distinctRuns(const Plan& plan);

/// Asks every arm's program for its resolved INI, so that a mistake in one fails here.
/// Throws core::UsageError or core::Error with the place in the experiment's INI.
Plan planOf(const Experiment& experiment);

}  // namespace ariadne::batch
