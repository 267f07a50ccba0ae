// The drive of a loop experiment as the robot sees it on a seed: a scripted one in a simulated
// world, or a log whose poses are taken for true.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "ariadne/experiment/loop_config.h"
#include "ariadne/sim/drive.h"

namespace ariadne::experiment {

/// The drive of an experiment, simulated once, with the noise of any seed.
class Drives {
 public:
  /// Drives or reads once; observing is cheap. @param laps of a scripted drive; else its file's.
  /// Throws core::UsageError unless there is either world and path or log, core::Error for a file
  /// that cannot be used.
  Drives(const LoopConfig& config, std::optional<int> laps);

  /// Same seed, same bits.
  sim::SimulatedDrive observe(std::uint64_t seed) const;
  /// Of the file of path or log, without folder and endings.
  const std::string& name() const { return name_; }
  /// Rounds in the inner loop.
  int laps() const { return laps_; }

 private:
  void readLog(const LoopConfig& config);

  std::string name_;
  int laps_ = 0;
  sim::NoiseParams noise_;
  LogNoise log_noise_;
  std::optional<sim::TruthDrive> simulated_;
  sim::SimulatedDrive log_;  ///< without noise
};

}  // namespace ariadne::experiment
