#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/eval/map_entropy.h"
#include "ariadne/report/replay_truth.h"
#include "replay_fixture.h"

using namespace ariadne;
using report::ReplayRecorder;
using test::MadeUpRun;

namespace {

report::RecorderParams atMost(std::size_t frames) {
  report::RecorderParams params;
  params.max_frames = frames;
  params.updates_a_frame = 1;
  return params;
}

std::vector<std::size_t> framesOf(const report::Replay& replay) {
  std::vector<std::size_t> steps;
  for (const auto& f : replay.frames) steps.push_back(f.step);
  return steps;
}

}  // namespace

TEST(ReplayRecorder, KeyframesStayFewAndSpreadOverTheRun) {
  ReplayRecorder recorder(atMost(20));
  MadeUpRun run(3, 5);
  for (int i = 0; i < 500; ++i) run.update(recorder, 5);
  const report::Replay replay = recorder.finish(run.view());
  const auto steps = framesOf(replay);
  EXPECT_EQ(replay.steps.size(), 500U);
  EXPECT_LE(steps.size(), 21U);
  EXPECT_GE(steps.size(), 10U);
  EXPECT_EQ(steps.front(), 0U);
  EXPECT_EQ(steps.back(), 499U);
  // 500 updates need a keyframe every 32 of them: at 16 there would be 32 keyframes.
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_LE(steps[i] - steps[i - 1], 32U);
}

TEST(ReplayRecorder, MomentsAndChangesOfTheLoopStateKeepTheirKeyframes) {
  ReplayRecorder recorder(atMost(20));
  MadeUpRun run(3, 5);
  for (std::size_t i = 0; i < 500; ++i) {
    if (i == 37) recorder.mark({0, report::MomentKind::decision, "go north", "", {}});
    run.state = i < 101 ? loops::LoopState::exploring : loops::LoopState::closing;
    run.update(recorder, 5);
  }
  const report::Replay replay = recorder.finish(run.view());
  ASSERT_EQ(replay.moments.size(), 1U);
  EXPECT_EQ(replay.moments[0].step, 37U);
  const auto steps = framesOf(replay);
  EXPECT_EQ(std::count(steps.begin(), steps.end(), 37U), 1);
  EXPECT_EQ(std::count(steps.begin(), steps.end(), 101U), 1);
  EXPECT_LE(steps.size(), 21U);
}

TEST(ReplayRecorder, WhatIsMarkedAfterTheLastUpdateBelongsToIt) {
  ReplayRecorder recorder(atMost(20));
  MadeUpRun run(3, 5);
  for (int i = 0; i < 10; ++i) run.update(recorder, 5);
  recorder.mark({0, report::MomentKind::decision, "the end", "", {}});
  const report::Replay replay = recorder.finish(run.view());
  ASSERT_EQ(replay.moments.size(), 1U);
  EXPECT_EQ(replay.moments[0].step, 9U);
}

TEST(ReplayRecorder, MoreMomentsThanKeyframesAreStillBounded) {
  ReplayRecorder recorder(atMost(20));
  MadeUpRun run(3, 5);
  for (int i = 0; i < 200; ++i) {
    recorder.mark({0, report::MomentKind::decision, "again", "", {}});
    run.update(recorder, 5);
  }
  const report::Replay replay = recorder.finish(run.view());
  EXPECT_LE(replay.frames.size(), 21U);
  EXPECT_EQ(replay.moments.size(), 200U);
}

TEST(ReplayRecorder, CloudsAreThinnedByTheirNumberOfParticles) {
  report::RecorderParams params;
  params.max_particles = 10;
  params.max_clouded = 400;
  ReplayRecorder recorder(params);
  MadeUpRun run(25, 5);  // every third is drawn
  for (int i = 0; i < 100; ++i) run.update(recorder, 1);
  const report::Replay replay = recorder.finish(run.view());
  EXPECT_EQ(replay.clouds.front().particles.size(), 9U);
  EXPECT_LE(9 * replay.clouds.size(), 400U);
  EXPECT_GT(9 * replay.clouds.size(), 180U);
  EXPECT_EQ(replay.particles, 25U);
}

TEST(ReplayRecorder, MapEntropyIsThatOfTheMap) {
  ReplayRecorder recorder(atMost(100));
  MadeUpRun run(2, 5);
  for (int i = 0; i < 30; ++i) {
    run.update(recorder, 200);
    if (i == 20) run.best().map.clear();
  }
  const report::Replay replay = recorder.finish(run.view());
  const grid::OccupancyGrid& map = run.best().map;
  const grid::CellBox box = map.knownBox();
  double expected = 0;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x)
      if (map.at({x, y}) != 0) expected += eval::cellEntropy(map.at({x, y}));
  EXPECT_GT(expected, 100);
  EXPECT_NEAR(*replay.steps.back().map_entropy, expected, 1e-9 * expected) << "summation order";
}

TEST(ReplayRecorder, DistanceIsThatOfTheBestParticleAndPathItsOwn) {
  ReplayRecorder recorder(atMost(100));
  MadeUpRun run(1, 1000);
  for (int i = 0; i < 11; ++i) run.update(recorder, 1);
  const report::Replay replay = recorder.finish(run.view());
  EXPECT_NEAR(replay.steps.back().distance_m, 3, 0.5) << "0.1 m of noise a step";
  EXPECT_EQ(replay.frames.back().path.size(), 11U);
  EXPECT_FALSE(replay.steps.back().unique_ancestors) << "no graphs, no loops";
}

TEST(ReplayRecorder, IsAsNewAfterFinish) {
  ReplayRecorder recorder(atMost(100));
  MadeUpRun run(2, 5);
  EXPECT_TRUE(recorder.finish(run.view()).steps.empty());
  run.update(recorder, 10);
  EXPECT_EQ(recorder.finish(run.view()).steps.size(), 1U);
  run.update(recorder, 10);
  const report::Replay second = recorder.finish(run.view());
  EXPECT_EQ(second.steps.size(), 1U);
  EXPECT_FALSE(second.frames.at(0).map.empty());
}

TEST(ReplayTruth, GivesPoseAndErrorWhereThereIsOne) {
  ReplayRecorder recorder(atMost(100));
  MadeUpRun run(1, 1000);
  for (int i = 0; i < 10; ++i) run.update(recorder, 1);
  report::Replay replay = recorder.finish(run.view());
  // The truth's frame is turned by 90 degrees and 1 m off; 0.5 m of error; ends after five updates.
  geometry::Trajectory truth;
  for (int i = 0; i < 5; ++i) {
    const auto& p = replay.steps[i].map_from_robot;
    truth.push_back({replay.steps[i].time_s, {p.y, -(p.x - 1) - 0.5, p.phi - M_PI / 2}});
  }
  report::addTruth(replay, truth, {1, 0, M_PI / 2}, 0.1);
  ASSERT_TRUE(replay.steps[3].error_m);
  EXPECT_NEAR(*replay.steps[3].error_m, 0.5, 1e-9);
  EXPECT_NEAR(replay.steps[3].truth->phi, replay.steps[3].map_from_robot.phi, 1e-9);
  EXPECT_FALSE(replay.steps[7].truth);
}
