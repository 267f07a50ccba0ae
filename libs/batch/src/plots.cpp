#include "ariadne/batch/plots.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/find_program.h"
#include "ariadne/process/process.h"
#include "plot_script.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit_s = 300;

fs::path findGnuplot() {
  const fs::path program = process::findInPath("gnuplot");
  if (program.empty())
    throw core::Error("plots are drawn by gnuplot, which is missing: install gnuplot-nox");
  return program;
}

/// Where gnuplot says what is wrong; above it stands the line of the script.
std::string lastLine(std::string words) {
  words.erase(words.find_last_not_of(" \n") + 1);
  return words.substr(words.rfind('\n') + 1);
}

void callGnuplot(const fs::path& script) {
  // -d: without what the user's own start files say
  process::Process process({findGnuplot().string(), "-d", script.string()}, {});
  const process::ProcessEnd end = endOf(process, kLimit_s, "gnuplot");
  if (end.signal != 0 || end.exit_code != 0)
    throw core::Error(fmt::format("gnuplot: {}: {}", describe(end), lastLine(end.last_words)));
}

}  // namespace

std::vector<Picture> drawPlots(const std::vector<Plot>& plots) {
  if (plots.empty()) return {};
  const io::ScratchFolder folder("plots");
  const fs::path script = folder.path() / "plots.gp";
  io::writeWhole(script, gnuplotScript(plots, folder.path()));
  callGnuplot(script);
  std::vector<Picture> pictures;
  for (const Plot& plot : plots)
    pictures.push_back({plot.name, io::readWhole(folder.path() / (plot.name + ".svg")),
                        io::readWhole(folder.path() / (plot.name + ".png"))});
  return pictures;
}

void writePictures(const std::vector<Picture>& pictures, const fs::path& folder) {
  if (pictures.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  for (const Picture& picture : pictures) {
    io::writeWhole(folder / (picture.name + ".svg"), picture.svg);
    io::writeWhole(folder / (picture.name + ".png"), picture.png);
  }
}

}  // namespace ariadne::batch
