#include "ariadne/report/report_page.h"

#include <functional>

#include "ariadne/io/whole_file.h"
#include "page_files.h"
#include "replay_json.h"
#include "thinning.h"

namespace ariadne::report {
namespace {

/// Text as HTML.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      default:
        out += c;
    }
  return out;
}

/// The template with each {{name}} replaced; what comes in is not looked through again.
std::string filled(std::string_view page,
                   const std::function<std::string(std::string_view name)>& part) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = page.find("{{", at);
    out += page.substr(at, open - at);
    if (open == std::string_view::npos) return out;
    const std::size_t close = page.find("}}", open);
    out += part(page.substr(open + 2, close - open - 2));
    at = close + 2;
  }
}

std::string pageOf(const Replay& replay) {
  return filled(kPageHtml, [&](std::string_view name) -> std::string {
    if (name == "title") return escaped(replay.title);
    if (name == "style") return std::string(kPageStyle);
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
