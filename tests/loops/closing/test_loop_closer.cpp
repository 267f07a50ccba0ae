// LoopCloser on a small filter that is driven round the corridor of corridor.h and on into its
// second lap: what it saves, recovers and tells, without the mapper around it.
#include <gtest/gtest.h>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/closing/loop_closer.h"
#include "closing/set_figures.h"
#include "corridor.h"

using namespace ariadne;
using loops::leavesOf;
using loops::LoopCloser;
using loops::LoopReport;
using loops::LoopState;
using mrpt::math::TPose2D;

namespace {

constexpr double kStep_m = 0.5;
constexpr std::size_t kLap = 200;  // updates: 100 m
constexpr std::size_t kEnd = 240;  // 20 m into the second lap

/// Poses by a precise odometry alone; a closing ends once Neff has a window after the entry.
struct Driven {
  filter::FilterModels filter;
  loops::LoopCloserParams loops;
};
Driven driven() {
  Driven p;
  p.filter.filter.particles = 4;
  p.filter.filter.proposal = filter::Proposal::odometry;
  p.filter.grid.resolution_m = 0.2;
  p.filter.motion = {false, 0.01, 0.05, 0.005, 0.001, 0.005, 0.01, 0.001};
  p.loops.grid = p.filter.grid;
  p.loops.closing.search = false;
  p.loops.closing.stop = loops::Stop::neff;
  p.loops.closing.neff_change = 1;
  p.loops.closing.neff_window_m = 5;  // four particles are resampled about each 10 m
  p.loops.checkpoint_updates = 20;
  return p;
}

class Drive {
 public:
  explicit Drive(const Driven& p)
      : params_(p),
        particles(p.filter, parallel_, test::corridorDrive(kStep_m)[0],
                  grid::OccupancyGrid(p.filter.grid)),
        closer(p.loops, parallel_) {}

  /// Up to the update; returns the closing that ended in the last one.
  std::optional<std::size_t> to(std::size_t update) {
    std::optional<std::size_t> ended;
    while (particles.step() <= update && !ended) ended = next();
    return ended;
  }

 private:
  std::optional<std::size_t> next() {
    static const auto poses = test::corridorDrive(kStep_m);
    static const test::CorridorWorld world;
    const std::size_t k = particles.step();
    const TPose2D& pose = poses[k % kLap];
    core::RandomStream rng(1, static_cast<std::uint32_t>(k), 0, core::Purpose::test);
    scans.push_back(mrpt::obs::CObservation2DRangeScan::Create(world.scan(pose, rng)));
    const grid::Scan scan =
        grid::takeScan(scans.back(), params_.filter.grid,
                       static_cast<std::size_t>(params_.filter.matcher.max_beams));
    particles.predict(k == 0 ? TPose2D() : geometry::relativePose(poses[(k - 1) % kLap], pose));
    particles.match(scan);
    particles.weigh(scan);
    const double neff = particles.neff();
    if (neff < 2) particles.resample();
    particles.insert(scan, params_.loops.checkpoint_updates);
    closer.extend(particles, scan);
    const LoopCloser::Watched watched = closer.watch(particles, neff);
    report = watched.report;
    return watched.ended;
  }

  Driven params_;
  core::Parallel parallel_{1};

 public:
  filter::ParticleSet particles;
  LoopCloser closer;
  std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> scans;
  LoopReport report;
};

}  // namespace

TEST(LoopCloser, SavesTheSetAsOfTheEntryWhenALoopIsDetected) {
  Drive drive(driven());
  drive.to(100);
  EXPECT_TRUE(drive.closer.records().empty()) << "half a lap";
  EXPECT_EQ(drive.report.state, LoopState::exploring);
  while (drive.closer.records().empty() && drive.particles.step() < kLap)
    drive.to(drive.particles.step());
  ASSERT_EQ(drive.closer.records().size(), 1U);
  EXPECT_EQ(drive.report.state, LoopState::approaching);
  EXPECT_GT(drive.report.opportunities, 0U);
  ASSERT_TRUE(drive.report.dist_m && drive.report.dist_g);
  EXPECT_LT(*drive.report.dist_m, driven().loops.closing.opportunity.c1_m);
  EXPECT_GT(*drive.report.dist_g, driven().loops.closing.opportunity.c2_m);

  const loops::ClosingRecord record = drive.closer.records()[0];
  EXPECT_LT(record.closing.opportunity.te, 10U) << "where it began";
  ASSERT_TRUE(record.saving);
  EXPECT_EQ(record.saving->entries, 4U);
  EXPECT_EQ(record.saving->at_te.poses.size(), 4U);
  EXPECT_LE(record.saving->distinct_ancestors, record.saving->existed);
  EXPECT_GT(record.saving->memory_mb, 0);
  EXPECT_EQ(drive.closer.openClosings().size(), 1U);
  EXPECT_NE(record.note.find("still open at the end of the log"), std::string::npos);
}

TEST(LoopCloser, TheLoopEntersEveryGraphAtTheEntry) {
  Drive drive(driven());
  drive.to(170);
  std::vector<double> before;  // by the graph, to where the drive began
  for (const auto& graph : drive.closer.graphs()) before.push_back(graph.distances()[0]);
  drive.to(kLap + 4);
  EXPECT_EQ(drive.report.state, LoopState::closing);
  ASSERT_EQ(drive.closer.graphs().size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(before[i], 60);
    EXPECT_LT(drive.closer.graphs()[i].distances()[0], 10);
  }
}

TEST(LoopCloser, RecoversWhatWasSavedWhenTheClosingEnds) {
  Drive drive(driven());
  const auto ended = drive.to(kEnd);
  ASSERT_TRUE(ended);
  const std::size_t update = drive.particles.step() - 1;
  const std::size_t te = drive.closer.records()[0].closing.opportunity.te;
  const auto before = leavesOf(drive.particles);
  drive.closer.recover(*ended, drive.particles, drive.scans);

  const loops::ClosingRecord record = drive.closer.records()[0];
  ASSERT_TRUE(record.recovery) << record.note;
  EXPECT_EQ(record.recovery->update, update);
  EXPECT_EQ(record.recovery->before, before);
  EXPECT_EQ(record.recovery->after, leavesOf(drive.particles));
  EXPECT_EQ(record.recovery->distinct_before, filter::distinctAncestors(before, te));
  EXPECT_EQ(record.recovery->distinct_after,
            filter::distinctAncestors(leavesOf(drive.particles), te));
  EXPECT_EQ(record.recovery->distinct_after, record.saving->distinct_ancestors);
  EXPECT_EQ(drive.particles.step(), update + 1) << "the filter goes on where it was";
  EXPECT_TRUE(record.note.empty()) << record.note;
  EXPECT_EQ(drive.closer.graphs().size(), 4U);
  for (const auto& graph : drive.closer.graphs()) EXPECT_EQ(graph.visits().size(), update + 1);
}

TEST(LoopCloser, WithoutRecoveryTheSetStaysAndTheRecordSaysWhy) {
  Drive drive(driven());
  drive.closer.disableRecovery();
  const auto ended = drive.to(kEnd);
  ASSERT_TRUE(ended);
  const auto before = leavesOf(drive.particles);
  drive.closer.recover(*ended, drive.particles, drive.scans);
  EXPECT_EQ(leavesOf(drive.particles), before);
  EXPECT_FALSE(drive.closer.records()[0].recovery);
  EXPECT_EQ(drive.closer.records()[0].note, "recovery is off");
}

TEST(LoopCloser, ASetThatIsTooBigIsDroppedAndTold) {
  Driven small = driven();
  small.loops.recovery.memory_budget_mb = 1e-3;
  Drive drive(small);
  const auto ended = drive.to(kEnd);
  ASSERT_TRUE(ended);
  const auto before = leavesOf(drive.particles);
  drive.closer.recover(*ended, drive.particles, drive.scans);
  EXPECT_EQ(leavesOf(drive.particles), before);
  const loops::ClosingRecord record = drive.closer.records()[0];
  EXPECT_TRUE(record.dropped);
  EXPECT_NE(record.note.find("recovery.memory_budget_mb"), std::string::npos) << record.note;
}

TEST(LoopCloser, AnEntryThatIsNotComeToIsGivenUp) {
  Driven hasty = driven();
  hasty.loops.closing.approach_limit_m = 2;
  Drive drive(hasty);
  EXPECT_FALSE(drive.to(kLap - 8));
  ASSERT_FALSE(drive.closer.records().empty());
  EXPECT_NE(drive.closer.records()[0].note.find("did not come to the entry"), std::string::npos);
  EXPECT_TRUE(drive.closer.openClosings().empty());
}

TEST(LoopCloser, SwitchedOffItKeepsNoGraphs) {
  Driven off = driven();
  off.loops.closing.enabled = false;
  Drive drive(off);
  EXPECT_FALSE(drive.to(20));
  EXPECT_TRUE(drive.closer.graphs().empty());
  EXPECT_TRUE(drive.closer.records().empty());
}

// A count at te of the open closing is that of its set, however the lines have merged since.
TEST(LoopCloser, UniqueAncestorsAreThoseAtTheOpenClosingsEntry) {
  Drive drive(driven());
  drive.to(kLap + 4);
  ASSERT_EQ(drive.closer.openClosings().size(), 1U);
  const std::size_t te = drive.closer.openClosings()[0]->opportunity.te;
  EXPECT_EQ(drive.report.unique_ancestors,
            filter::distinctAncestors(leavesOf(drive.particles), te));
}
