#include "ariadne/charts/gnuplot.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/find_program.h"
#include "ariadne/process/process.h"

namespace ariadne::charts {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit_s = 300;

fs::path findGnuplot() {
  const fs::path program = process::findInPath("gnuplot");
  if (program.empty())
    throw GnuplotMissing("charts are drawn by gnuplot, which is missing: install gnuplot-nox");
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

std::vector<std::string> drawnFiles(const std::vector<std::string>& names,
                                    const std::function<std::string(const fs::path&)>& script) {
  const io::ScratchFolder folder("charts");
  const fs::path file = folder.path() / "script.gp";
  io::writeWhole(file, "set encoding utf8\n" + script(folder.path()));
  callGnuplot(file);
  std::vector<std::string> drawn;
  drawn.reserve(names.size());
  for (const std::string& name : names) drawn.push_back(io::readWhole(folder.path() / name));
  return drawn;
}

}  // namespace ariadne::charts
