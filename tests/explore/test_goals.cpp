// The goals one by one, each asked on a map that is drawn.
#include <gtest/gtest.h>

#include "ariadne/explore/frontier_goal.h"
#include "ariadne/explore/home_goal.h"
#include "ariadne/explore/loop_goal.h"
#include "drawn_map.h"

using namespace ariadne;
using explore::DecisionKind;
using explore::Purpose;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

namespace {

/// A room of 6 x 3 m whose right end is open to the unknown, and a robot in it that came along its
/// middle line, an update each 0.5 m.
struct RoomOfGoals {
  explicit RoomOfGoals(bool closed = false) : map(drawn(closed)) {
    for (std::size_t k = 0; k <= 8; ++k)
      path = std::make_shared<filter::Ancestor>(
          path, k, TPose2D(1 + 0.5 * static_cast<double>(k), 1.5, 0), 0.0);
  }
  static grid::OccupancyGrid drawn(bool closed) {
    std::vector<std::string> rows(15, "#" + std::string(28, '.') + (closed ? "#" : "."));
    rows.front() = rows.back() = std::string(30, '#');
    return test::drawnMap(rows, 4);
  }
  explore::Belief belief() const {
    return {10, path->step() + 1, path->pose(), map, path, open, scan, false};
  }
  template <class Goal>
  explore::Answer ask(Goal& goal, const explore::Heading& heading = {}, bool arrived = false) {
    const explore::Belief now = belief();
    const explore::Planner planner(
        std::make_shared<explore::PlanningGrid>(map, 0.1, std::vector<TPoint2D>()),
        {now.map_from_robot.x, now.map_from_robot.y}, params);
    const explore::Question question{now, planner, heading, arrived};
    if constexpr (std::is_same_v<Goal, explore::HomeGoal>)
      return goal.answer(question, {}, log);
    else
      return goal.answer(question, log);
  }
  std::vector<DecisionKind> noted() const {
    std::vector<DecisionKind> kinds;
    for (const auto& d : log.decisions()) kinds.push_back(d.kind);
    return kinds;
  }

  explore::ExploreParams params;
  grid::OccupancyGrid map;
  filter::AncestorPtr path;
  std::vector<const loops::Closing*> open;
  mrpt::obs::CObservation2DRangeScan scan;
  explore::Logbook log;
};

/// Its entry is where the robot was at update 1.
loops::Closing loop() {
  loops::Closing c;
  c.id = 4;
  c.opportunity.te = 1;
  c.entry_position = {1.5, 1.5};
  return c;
}

using Kinds = std::vector<DecisionKind>;

}  // namespace

TEST(FrontierGoal, GoesToTheOpenEndAndKeepsIt) {
  RoomOfGoals room;
  explore::FrontierGoal goal(room.params);
  const auto first = room.ask(goal);
  ASSERT_TRUE(first.where) << first.why_not;
  EXPECT_EQ(first.where->heading.purpose, Purpose::frontier);
  EXPECT_GT(first.where->heading.at.x, 5.5);
  EXPECT_GT(first.where->route.back().x, 5);
  EXPECT_EQ(room.noted(), Kinds{DecisionKind::frontier});
  ASSERT_TRUE(room.ask(goal, first.where->heading).where);
  EXPECT_EQ(room.log.decisions().size(), 1U) << "the robot is on its way to it";
}

TEST(FrontierGoal, OneThatFailedIsLeftForThatReason) {
  RoomOfGoals room;
  explore::FrontierGoal goal(room.params);
  for (double y = 0; y <= 3; y += 0.25) goal.fail({6, y}, "it did not give way");
  const auto answer = room.ask(goal);
  EXPECT_FALSE(answer.where);
  EXPECT_EQ(answer.why_not, "explored: every frontier that is left has a reason");
  ASSERT_EQ(goal.frontiers().size(), 1U);
  EXPECT_EQ(goal.frontiers()[0].left, "it did not give way");
}

TEST(FrontierGoal, AClosedRoomHasNone) {
  RoomOfGoals room(true);
  explore::FrontierGoal goal(room.params);
  EXPECT_EQ(room.ask(goal).why_not, "explored: no frontier is left");
}

TEST(HomeGoal, LeadsToTheFirstPoseWhereItIsWanted) {
  RoomOfGoals room;
  explore::HomeGoal stays(room.params);
  EXPECT_EQ(room.ask(stays).why_not, "drive_home is false");
  room.params.drive_home = true;
  explore::HomeGoal home(room.params);
  const auto answer = room.ask(home);
  ASSERT_TRUE(answer.where);
  EXPECT_NEAR(answer.where->route.back().x, 1, 0.5) << "the first place about it is enough";
  room.ask(home, answer.where->heading);
  EXPECT_EQ(room.noted(), Kinds{DecisionKind::home}) << "set out once";
}

TEST(LoopGoal, WithoutAnOpenLoopOrAnActiveStrategyThereIsNone) {
  RoomOfGoals room;
  explore::LoopGoal none(room.params);
  EXPECT_FALSE(none.isThere(room.belief()));
  EXPECT_FALSE(room.ask(none).where);
  const auto open = loop();
  room.open = {&open};
  EXPECT_TRUE(none.isThere(room.belief()));
  room.params.strategy = explore::Strategy::frontier;
  explore::LoopGoal passive(room.params);
  EXPECT_FALSE(passive.isThere(room.belief()));
  EXPECT_FALSE(room.ask(passive).where);
}

TEST(LoopGoal, DrivesToTheEntryAndGivesUpWhereItIsNotRecognised) {
  RoomOfGoals room;
  const auto open = loop();
  room.open = {&open};
  explore::LoopGoal goal(room.params);
  const auto answer = room.ask(goal);
  ASSERT_TRUE(answer.where);
  EXPECT_EQ(answer.where->heading.purpose, Purpose::entry);
  EXPECT_NEAR(answer.where->heading.at.x, 1.5, 1e-9);
  ASSERT_TRUE(room.ask(goal, answer.where->heading).where);
  const auto there = room.ask(goal, answer.where->heading, true);
  EXPECT_EQ(there.why_not, "leaves the loop: at the entry's place the robot does not recognise it");
  EXPECT_EQ(room.noted(), (Kinds{DecisionKind::approach, DecisionKind::give_up}));
  goal.look(room.map);
  EXPECT_FALSE(goal.isThere(room.belief()));
}

TEST(LoopGoal, AnEntryIsGoneToAgainWhenTheMapThereHasChanged) {
  RoomOfGoals room;
  const auto open = loop();
  room.open = {&open};
  explore::LoopGoal goal(room.params);
  room.ask(goal);
  EXPECT_TRUE(goal.giveUp(room.belief(), "blocked", room.log));
  EXPECT_FALSE(room.ask(goal).where);
  for (int y = 20; y < 50; ++y)
    for (int x = 20; x < 40; ++x) room.map.set({x, y}, -50);  // 1.5 m^2 are taken
  goal.look(room.map);
  EXPECT_TRUE(goal.isThere(room.belief()));
}

TEST(LoopGoal, FollowsThePathFromTheEntryAndLeavesAfterItsLaps) {
  RoomOfGoals room;
  auto open = loop();
  open.entered = 8;
  room.open = {&open};
  room.params.max_laps = 1;
  explore::LoopGoal goal(room.params);
  auto answer = room.ask(goal);
  ASSERT_TRUE(answer.where);
  EXPECT_EQ(answer.where->heading.purpose, Purpose::loop);
  int places = 1;
  for (; answer.where && places < 20; ++places)
    answer = room.ask(goal, answer.where->heading, true);
  EXPECT_EQ(answer.why_not, "leaves the loop: followed for 1 laps (max_laps)");
  EXPECT_LE(places, 5) << "a few metres at a time";
  EXPECT_EQ(room.noted(), (Kinds{DecisionKind::follow, DecisionKind::give_up}));
  EXPECT_FALSE(goal.isThere(room.belief()));
}
