#include "repeats.h"

#include <fmt/format.h>

#include "ariadne/io/ini_writer.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;

std::string seedOf(const Contest& c, int repeat) {
  return std::to_string(c.ours.slam.filter.seed + static_cast<std::uint64_t>(repeat - 1));
}

process::ProcessEnd runOurs(const Contest& c, int repeat) {
  const fs::path folder = oursFolder(c, repeat);
  std::vector<std::string> command{c.slam_program, (c.folder / "ours.ini").string(),
                                   "--seed",       seedOf(c, repeat),
                                   "--out",        folder.string(),
                                   "--quiet"};
  if (c.overwrite) command.emplace_back("--overwrite");
  return process::runToEnd(command, folder.string() + ".log");
}

process::ProcessEnd runStock(const Contest& c, int repeat) {
  const fs::path folder = stockFolder(c, repeat);
  fs::create_directory(folder);
  const auto file = [&](const char* name) { return (folder / name).string(); };
  return process::runToEnd(
      {c.stock_program, (c.folder / "stock.ini").string(), c.ours.dataset.file, "--seed",
       seedOf(c, repeat), "--path", file("path.tum"), "--trajectory", file("mean.tum"),
       "--overview", file("overview.png"), "--summary", file("summary.json")},
      folder.string() + ".log");
}

}  // namespace

fs::path oursFolder(const Contest& c, int repeat) {
  return c.folder / fmt::format("ours-{}", repeat);
}

fs::path stockFolder(const Contest& c, int repeat) {
  return c.folder / fmt::format("stock-{}", repeat);
}

std::vector<ComparedFigure> runContest(const Contest& c,
                                       const std::function<void(const std::string&)>& tell) {
  io::writeWhole(c.folder / "ours.ini",
                 io::writeIni(c.ours, "As ariadne-compare gave it to ariadne-slam."));
  io::writeWhole(c.folder / "stock.ini", c.stock_ini);
  std::vector<ComparedFigure> compared;
  for (const FigureKind& kind : figureKinds(c.references)) compared.push_back({kind, {}, {}});
  // In turns, so that a busy machine is busy for both.
  for (int repeat = 1; repeat <= c.repeats; ++repeat) {
    tell(fmt::format("run {} of {}: ariadne-slam", repeat, c.repeats));
    const Figures ours = figuresOfOurs(oursFolder(c, repeat), runOurs(c, repeat), c.references);
    tell(fmt::format("run {} of {}: stock MRPT", repeat, c.repeats));
    const Figures stock = figuresOfStock(stockFolder(c, repeat), runStock(c, repeat), c.references);
    for (ComparedFigure& f : compared) {
      f.ours.push_back(ours.at(f.kind.name()));
      f.stock.push_back(stock.at(f.kind.name()));
    }
  }
  return compared;
}

}  // namespace ariadne::compare_app
