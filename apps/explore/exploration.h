// The run itself: a mission, recorded and shown while it goes on, then measured by the truth.
#pragma once
#include "ariadne/eval/map_score.h"
#include "ariadne/report/replay_recorder.h"
#include "explore_config.h"
#include "interrupt.h"
#include "progress.h"
#include "summary.h"

namespace ariadne::explore_app {

struct ExplorationResult {
  ExploreConfig config;
  mission::MissionRecord mission;
  std::vector<explore::Decision> decisions;
  double slowest_decision_s = 0;
  double decisions_s = 0;        ///< CPU time of all decisions
  slam_app::RunResult mapping;   ///< of the drive, as ariadne-slam has it
  double coverage = 0;           ///< mission::coverage()
  eval::MapScore score;          ///< against the world's walls, by [map_score]
  eval::MapScore score_by_grid;  ///< against the walls of a grid of all that can be seen
  eval::LoopErrors loop_errors;  ///< across the true loop closures
  eval::Verdict loops = eval::Verdict::no_loop;  ///< of these by [correct]
  std::string verdict;  ///< correct; bent: the loops are, the walls are not; wrong; no_loop
};

/// Runs the mission until it ends or a signal comes. What the truth says is still missing.
ExplorationResult carryOut(mission::Mission& mission, const ExploreConfig& config,
                           const app::Interrupt& interrupt, app::Progress& progress,
                           report::ReplayRecorder& recorder);

/// Adds what the truth says. @param start world_from_robot
void measure(ExplorationResult& result, const mission::Mission& mission, const sim::World& world,
             const mrpt::math::TPose2D& start);

}  // namespace ariadne::explore_app
