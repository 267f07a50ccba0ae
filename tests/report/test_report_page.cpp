#include <gtest/gtest.h>

#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "replay_fixture.h"

using namespace ariadne;
using test::dataOf;
using test::MadeUpRun;

namespace {

report::Replay shortReplay() {
  report::ReplayRecorder recorder;
  MadeUpRun run(3, 5);
  for (int i = 0; i < 10; ++i) run.update(recorder, 50);
  return recorder.finish(run.view());
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

class ReportPage : public TemporaryFolder {};

TEST_F(ReportPage, HoldsTheRunAsJson) {
  report::Replay replay = shortReplay();
  replay.title = "a run";
  replay.steps[4].error_m = 0.25;
  for (std::size_t i = 6; i < 10; ++i) replay.steps[i].time_s -= 1000;  // its clock is set back
  replay.moments.push_back({3, report::MomentKind::recovery, "back", "why", {{"a", "b"}}});
  report::writeReport(folder / "report.html", replay);
  const auto data = dataOf(io::readWhole(folder / "report.html"));
  EXPECT_EQ(data["title"], "a run");
  EXPECT_EQ(data["steps"]["time_ms"][5], 3000);
  EXPECT_EQ(data["steps"]["time_ms"][6], 3000);
  EXPECT_EQ(data["steps"]["time_ms"][9], 4800);
  EXPECT_EQ(data["steps"]["error_mm"][4], 250);
  EXPECT_TRUE(data["steps"]["error_mm"][5].is_null());
  EXPECT_EQ(data["moments"][0]["kind"], "recovery");
  EXPECT_EQ(data["clouds"].size(), 10U);
  EXPECT_EQ(data["clouds"][0].size(), 1U + 3 * 4);
  EXPECT_EQ(data["frames"].size(), replay.frames.size());
}

TEST_F(ReportPage, AnyTextIsShownLiterally) {
  report::Replay replay = shortReplay();
  const std::string nasty = "</script><b>\"it's\" & {{data}} <!-- <script>";
  replay.title = nasty;
  replay.facts = {{nasty, nasty}};
  replay.moments.push_back({3, report::MomentKind::decision, nasty, nasty, {{nasty}}});
  const std::string plain = report::reportHtml(shortReplay());
  const std::string page = report::reportHtml(replay);
  EXPECT_EQ(countOf(page, "</script"), countOf(plain, "</script"));
  EXPECT_EQ(countOf(page, "<b>"), countOf(plain, "<b>"));
  const auto data = dataOf(page);
  EXPECT_EQ(data["title"], nasty);
  EXPECT_EQ(data["moments"][0]["table"][0][0], nasty);
}

TEST_F(ReportPage, BytesThatAreNoTextAndNumbersThatAreNoneDoNotBreakIt) {
  report::Replay replay = shortReplay();
  replay.title = "log \xff\xfe.rawlog";
  replay.steps[2].neff = std::nan("");
  replay.steps[3].distance_m = HUGE_VAL;
  const auto data = dataOf(report::reportHtml(replay));
  EXPECT_EQ(data["steps"]["neff_milli"][2], 0);
}

TEST_F(ReportPage, NeedsNoOtherFileAndNoNetwork) {
  const std::string page = report::reportHtml(shortReplay());
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* loads : {"src=\"http", "href=\"http", "@import", "fetch(", "XMLHttpRequest"})
    EXPECT_EQ(page.find(loads), std::string::npos) << loads;
  EXPECT_NE(page.find("Chart.js v3"), std::string::npos) << "its licence's banner stays";
}

TEST_F(ReportPage, ARunWithoutStepsIsAPageToo) {
  EXPECT_TRUE(dataOf(report::reportHtml({}))["steps"]["time_ms"].empty());
}

// 1000 updates at 0.3 m are 300 m, ten minutes at half a metre a second; 100 particles. A map in
// which random cells change is the worst there is for the tiles.
TEST_F(ReportPage, TenMinutesAreUnderTenMegabytes) {
  report::ReplayRecorder recorder;
  MadeUpRun run(100, 20);
  for (int i = 0; i < 1000; ++i) run.update(recorder, 200);
  const report::Replay replay = recorder.finish(run.view());
  EXPECT_LE(replay.frames.size(), 500U);
  const std::string page = report::reportHtml(replay);
  EXPECT_LT(page.size(), 10'000'000U);
  EXPECT_GT(dataOf(page)["frames"].size(), 100U);
}

TEST_F(ReportPage, TooLargeAPageLosesKeyframesButNotTheLast) {
  const report::Replay replay = shortReplay();
  const std::string whole = report::reportHtml(replay);
  const auto all = dataOf(whole)["frames"].size();
  const auto left = dataOf(report::reportHtml(replay, whole.size() - 1))["frames"];
  EXPECT_LT(left.size(), all);
  EXPECT_EQ(left.back()["step"], 9);
  EXPECT_EQ(dataOf(report::reportHtml(replay, 1))["frames"].size(), 2U);
}

TEST_F(ReportPage, AFolderThatIsNoneIsNamed) {
  try {
    report::writeReport("/nowhere/report.html", {});
    ADD_FAILURE() << "no core::Error";
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find("/nowhere/report.html"), std::string::npos) << e.what();
  }
}
