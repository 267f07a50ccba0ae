#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/sim/drive_path.h"
#include "expect_error.h"

using ariadne::core::Error;
using ariadne::core::UsageError;
using ariadne::sim::DrivePath;
using ariadne::sim::parsePath;
using ariadne::test::expectError;

namespace {

void expectPathError(const std::string& text, const std::vector<std::string>& parts) {
  expectError<Error>([&] { parsePath(text, "p"); }, parts);
}

/// "0 1 2 1 2 3": the x of all waypoints.
std::string order(const DrivePath& path) {
  std::string out;
  for (const auto& w : path.waypoints)
    out += (out.empty() ? "" : " ") + std::to_string(static_cast<int>(w.at.x));
  return out;
}

const char* const kLaps =
    "laps 2\n"
    "mark A\n"
    "goto 0 0\n"
    "repeat laps\n"
    "  goto 1 0\n"
    "  repeat 2\n"
    "    goto 2 0\n"
    "  end\n"
    "end\n"
    "mark B\n"
    "goto 3 0\n"
    "mark C\n";

}  // namespace

TEST(DrivePath, BlocksAndLaps) {
  EXPECT_EQ(order(parsePath(kLaps, "p")), "0 1 2 2 1 2 2 3");
  EXPECT_EQ(order(parsePath(kLaps, "p", 1)), "0 1 2 2 3");
  EXPECT_EQ(order(parsePath(kLaps, "p", 0)), "0 3");
  EXPECT_EQ(parsePath(kLaps, "p").laps, 2);
  EXPECT_EQ(parsePath(kLaps, "p", 5).laps, 5);
  EXPECT_TRUE(parsePath(kLaps, "p").has_laps_block);
  EXPECT_FALSE(parsePath("goto 1 1", "p", 5).has_laps_block);
  EXPECT_EQ(parsePath(kLaps, "p").waypoints.back().line, 11);
}

TEST(DrivePath, MarksStandBehindTheirWaypoints) {
  const auto marks = parsePath(kLaps, "p").marks;
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_EQ(marks[0].name, "A");
  EXPECT_EQ(marks[0].after, 0U);
  EXPECT_EQ(marks[1].after, 7U);
  EXPECT_EQ(marks[2].after, 8U);
  EXPECT_EQ(parsePath(kLaps, "p", 0).marks[1].after, 1U);
  const auto repeated = parsePath("repeat 3\ngoto 1 1\nmark lap\nend", "p").marks;
  ASSERT_EQ(repeated.size(), 3U);
  EXPECT_EQ(repeated[2].after, 3U);
}

TEST(DrivePath, ErrorsSayWhereAndWhatWouldBeRight) {
  expectPathError("", {"p: no waypoint", "goto x y"});
  expectPathError("repeat 0\ngoto 1 1\nend", {"no waypoint"});
  expectPathError("gotto 1 1", {"p:1", "nearest is \"goto\""});
  expectPathError("goto 1", {"p:1", "1 words", "goto x y"});
  expectPathError("goto 1 inf", {"p:1", "coordinate 2", "inf"});
  expectPathError("goto 1 1\nend", {"p:2", "no `repeat`"});
  expectPathError("goto 1 1\nrepeat 2\nrepeat 3\nend", {"p:2", "`end` closes it"});
  expectPathError("repeat", {"p:1", "repeat laps"});
  expectPathError("repeat 2.5", {"p:1", "a whole number"});
  expectPathError("repeat -1", {"p:1", "0 to"});
  expectPathError("repeat laps\ngoto 1 1\nend", {"p:1", "laps N"});
  expectPathError("laps 1\nlaps 2", {"p:2", "a second one"});
  expectPathError("laps 1e3", {"p:1", "a whole number"});
  expectPathError("mark", {"p:1", "mark NAME"});
  expectPathError("mark a,b", {"p:1", "comma"});
  expectError<UsageError>([] { parsePath("goto 1 1", "p", -1); }, {"-1 laps"});
}

TEST(DrivePath, BlocksThatMultiplyAreRefusedBeforeTheyTakeMemory) {
  std::string text = "goto 1 1\n";
  for (int i = 0; i < 40; ++i) text = "repeat 1000\n" + text + "end\n";
  expectPathError(text, {"p:", "1000000 at most"});
  EXPECT_EQ(parsePath("repeat 1000\nrepeat 1000\ngoto 1 1\nend\nend", "p").waypoints.size(),
            1000000U);
}
