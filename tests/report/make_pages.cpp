// make_pages FOLDER: the pages that test_page.py looks at. full.html has all that a page can show,
// plain.html what a log without loops and truth gives, empty.html nothing.
#include <iostream>

#include "../shipped_datasets.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/tum.h"
#include "ariadne/report/replay_recorder.h"
#include "ariadne/report/replay_truth.h"
#include "ariadne/report/report_page.h"

using namespace ariadne;

namespace {

const std::string kNasty = "</script><b>bold</b> \"it's\" & <!-- &amp;.rawlog";

slam::SlamParams quickParams() {
  slam::SlamParams params;
  params.filter.particles = 8;
  params.grid.resolution_m = 0.1;
  return params;
}

/// What an exploring robot would show.
report::ReplayScene sceneAt(const mrpt::math::TPose2D& pose) {
  report::ReplayScene scene;
  scene.frontiers = {{{pose.x + 2, pose.y}, {pose.x + 2, pose.y + 0.1}}, {{pose.x - 3, pose.y}}};
  scene.plan = {{pose.x, pose.y}, {pose.x + 1, pose.y + 1}};
  scene.goal = {pose.x + 1, pose.y + 1};
  scene.shortcut = report::ReplayShortcut{{pose.x + 1, pose.y - 1}, {pose.x, pose.y}};
  return scene;
}

report::Replay drive(const slam::SlamParams& params, bool decides) {
  const auto source =
      io::openDataset((test::shippedDatasets() / "drives/small.rawlog").string(), {""});
  slam::Mapper mapper(params, 2);
  report::ReplayRecorder recorder;
  while (const auto step = source->next()) {
    const auto report = mapper.process(*step);
    if (!report) continue;
    if (decides && report->step % 50 == 10) {
      recorder.mark({0,
                     report::MomentKind::decision,
                     "Decided at " + std::to_string(report->step) + " <i>",
                     kNasty,
                     {{"frontier", "utility"}, {"1", "0.5"}, {"2", kNasty}}});
      recorder.show(sceneAt(report->map_from_robot));
    }
    if (decides && report->step == 30)
      recorder.mark({0, report::MomentKind::detection, "A loop is there", kNasty, {}});
    if (decides && report->step == 80)
      recorder.mark({0, report::MomentKind::recovery, "Hypotheses come back", kNasty, {}});
    recorder.step(*report, report::viewOf(mapper),
                  "at update " + std::to_string(report->step) + " <u>");
  }
  return recorder.finish(report::viewOf(mapper));
}

void makeAll(const std::filesystem::path& folder) {
  report::Replay full = drive(quickParams(), true);
  full.title = kNasty;
  full.facts = {{"Log", kNasty}, {"A long one", std::string(200, 'x')}};
  full.notes = {kNasty};
  report::addTruth(full, io::readTum(test::shippedDatasets() / "drives/small.rawlog.truth.tum"),
                   {0, 0, 0}, 1);
  report::writeReport(folder / "full.html", full);
  slam::SlamParams no_loops = quickParams();
  no_loops.loop_closing.enabled = false;
  report::Replay plain = drive(no_loops, false);
  plain.title = "plain";
  report::writeReport(folder / "plain.html", plain);
  report::Replay empty;
  empty.title = "empty";
  report::writeReport(folder / "empty.html", empty);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    makeAll(argv[1]);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  return 0;
}
