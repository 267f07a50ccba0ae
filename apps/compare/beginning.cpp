#include "beginning.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "ariadne/core/error.h"
#include "ariadne/io/scratch_folder.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/process/call.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTried = 10;
constexpr std::size_t kWorthIt = 30;

/// The file's first bytes, which both programs read as a log that was cut short.
void copyBeginning(const fs::path& from, double share, const fs::path& to) {
  const auto bytes = std::ceil(share * static_cast<double>(fs::file_size(from)));
  std::string text(static_cast<std::size_t>(bytes), '\0');
  std::ifstream in(from, std::ios::binary);
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  io::writeWhole(to, text);
}

/// Updates that the program made, of the figures in its summary.
using Count = std::function<double(const process::ProcessEnd&)>;

void tryOne(const std::vector<std::string>& command, const fs::path& folder, Side side,
            const Count& made, std::size_t all, Forecast& forecast) {
  try {
    // Starting is most of so short a run, and comes once.
    const std::string log = folder.string() + ".log";
    const double start_s = process::runToEnd({command[0], "--version"}, log).wall_s;
    const auto end = process::runToEnd(command, log);
    if (const double updates = made(end); updates > 0)
      forecast.expect(
          side, start_s + std::max(end.wall_s - start_s, 0.0) * static_cast<double>(all) / updates);
  } catch (const core::Error&) {  // the contest's run tells it
  }
}

}  // namespace

void tryBeginnings(const Contest& contest, const LogUpdates& updates, Forecast& forecast) {
  if (updates.count() < kWorthIt) return;
  const io::ScratchFolder scratch("compare");
  Contest c = contest;
  c.folder = scratch.path();
  c.ours.dataset.file = (scratch.path() / "beginning.rawlog").string();
  c.references = {};
  copyBeginning(contest.ours.dataset.file, updates.shareOfLog(kTried), c.ours.dataset.file);
  writeInis(c);
  const fs::path ours = oursFolder(c, 1);
  const fs::path stock = stockFolder(c, 1);
  tryOne(
      oursCommand(c, 1), ours, Side::ours,
      [&](const auto& end) { return figuresOfOurs(ours, end, {}).at("updates"); }, updates.count(),
      forecast);
  tryOne(
      stockCommand(c, 1), stock, Side::stock,
      [&](const auto& end) { return figuresOfStock(stock, end, {}).at("updates"); },
      updates.count(), forecast);
}

}  // namespace ariadne::compare_app
