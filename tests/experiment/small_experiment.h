// The nested-loop experiment in small: a drive of 65 m with a side ring, eight particles.
#pragma once
#include <cstdlib>
#include <string>

#include "ariadne/experiment/loop_run.h"

namespace ariadne::test {

struct Small {
  Small() {
    const std::string data = std::string(std::getenv("ARIADNE_SOURCE_DIR")) + "/datasets/";
    world = sim::readWorld(data + "worlds/small.world");
    drive_params.max_range_m = 8;
    drive_params.scan_rate_hz = 2;
    noise.turn_per_root_m_deg = 0.7;
    params.filter.particles = 8;
    params.filter.weight_gain = 0.02;
    params.grid.resolution_m = 0.1;
    params.grid.no_return_free_m = 8;
    // The side ring is 13 m round.
    params.loop_closing.opportunity.c1_m = 3;
    params.loop_closing.opportunity.c2_m = 7;
    params.loop_closing.places.place_spacing_m = 1;
    params.loop_closing.places.visit_radius_m = 0.8;
    params.loop_closing.leave_after_m = 2;
    params.loop_closing.cooldown_m = 3;
    drive = sim::driveThrough(world, sim::readPath(data + "drives/small.path", 2), drive_params);
  }
  experiment::LoopRunResult run(std::uint64_t seed) const {
    return experiment::runLoop(sim::observe(drive, noise, seed), params, {}, seed);
  }
  sim::World world;
  sim::DriveParams drive_params;
  sim::NoiseParams noise;
  slam::SlamParams params;
  sim::TruthDrive drive;
};

}  // namespace ariadne::test
