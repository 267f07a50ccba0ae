#include "ariadne/report/report_page.h"

#include "ariadne/io/whole_file.h"
#include "ariadne/page/head.h"
#include "ariadne/page/html.h"
#include "page_files.h"
#include "replay_json.h"
#include "thinning.h"

namespace ariadne::report {
namespace {

std::string pageOf(const Replay& replay) {
  return page::filledTemplate(kPageHtml, [&](std::string_view name) -> std::string {
    if (name == "title") return page::escapedHtml(replay.title);
    if (name == "head") return page::headHtml(replay.title, kPageStyle, page::Scripts::own);
    if (name == "chart.js") return std::string(kPageChartJs);
    if (name == "script") return std::string(kPageScript);
    return replayJson(replay);
  });
}

}  // namespace

std::string reportHtml(const Replay& replay, std::size_t largest) {
  std::string page = pageOf(replay);
  if (page.size() <= largest) return page;
  Replay fewer = replay;
  while (page.size() > largest && thin(fewer.frames)) {
    fewer.tiles = usedTiles(fewer.frames, fewer.tiles);
    page = pageOf(fewer);
  }
  return page;
}

void writeReport(const std::filesystem::path& file, const Replay& replay) {
  io::writeWhole(file, reportHtml(replay));
}

}  // namespace ariadne::report
