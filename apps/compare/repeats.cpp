#include "repeats.h"

#include <fmt/format.h>

#include "ariadne/io/ini_writer.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"
#include "ariadne/process/share_read.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;
using Command = std::vector<std::string>;

std::string seedOf(const Contest& c, int repeat) {
  return std::to_string(c.ours.slam.filter.seed + static_cast<std::uint64_t>(repeat - 1));
}

/// One run, with its progress told while it goes.
process::ProcessEnd timed(const Contest& c, Side side, const Command& command, const fs::path& log,
                          const LogUpdates& updates, Forecast& forecast, app::Progress& progress) {
  UnderWay now{side};
  progress.show(forecast.progressText(now));
  const auto end = process::runToEnd(command, log, [&](const process::Process& p) {
    if (!progress.due()) return;
    now.elapsed_s = p.elapsed_s();
    // Ours reads far ahead of what it maps: there the clock alone tells.
    const auto read =
        side == Side::stock ? process::shareRead(p.pid(), c.ours.dataset.file) : std::nullopt;
    if (read) now.share = updates.shareOfUpdates(*read);
    progress.show(forecast.progressText(now));
  });
  forecast.ended(side, end.wall_s);
  return end;
}

}  // namespace

fs::path oursFolder(const Contest& c, int repeat) {
  return c.folder / fmt::format("ours-{}", repeat);
}

fs::path stockFolder(const Contest& c, int repeat) {
  return c.folder / fmt::format("stock-{}", repeat);
}

Command oursCommand(const Contest& c, int repeat) {
  Command command{c.slam_program, (c.folder / "ours.ini").string(), "--seed", seedOf(c, repeat),
                  "--out",        oursFolder(c, repeat).string(),   "--quiet"};
  if (c.overwrite) command.emplace_back("--overwrite");
  return command;
}

Command stockCommand(const Contest& c, int repeat) {
  const fs::path folder = stockFolder(c, repeat);
  fs::create_directory(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  return {c.stock_program,      (c.folder / "stock.ini").string(),
          c.ours.dataset.file,  "--seed",
          seedOf(c, repeat),    "--path",
          file("path.tum"),     "--trajectory",
          file("mean.tum"),     "--overview",
          file("overview.png"), "--summary",
          file("summary.json")};
}

void writeInis(const Contest& c) {
  io::writeWhole(c.folder / "ours.ini",
                 io::writeIni(c.ours, "As ariadne-compare gave it to ariadne-slam."));
  io::writeWhole(c.folder / "stock.ini", c.stock_ini);
}

std::vector<ComparedFigure> runContest(const Contest& c, const LogUpdates& updates,
                                       Forecast& forecast, app::Progress& progress) {
  std::vector<ComparedFigure> compared;
  for (const FigureKind& kind : figureKinds(c.references)) compared.push_back({kind, {}, {}});
  // In turns, so that a busy machine is busy for both.
  for (int repeat = 1; repeat <= c.repeats; ++repeat) {
    const auto run = [&](Side side, const Command& command, const fs::path& folder) {
      return timed(c, side, command, folder.string() + ".log", updates, forecast, progress);
    };
    const fs::path ours_in = oursFolder(c, repeat);
    const auto ours_end = run(Side::ours, oursCommand(c, repeat), ours_in);
    const Figures ours = figuresOfOurs(ours_in, ours_end, c.references);
    const fs::path stock_in = stockFolder(c, repeat);
    const auto stock_end = run(Side::stock, stockCommand(c, repeat), stock_in);
    const Figures stock = figuresOfStock(stock_in, stock_end, c.references);
    for (ComparedFigure& f : compared) {
      f.ours.push_back(ours.at(f.kind.name()));
      f.stock.push_back(stock.at(f.kind.name()));
    }
  }
  progress.finish();
  return compared;
}

}  // namespace ariadne::compare_app
