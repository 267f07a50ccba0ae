#include "results_output.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>
#include <utility>

#include "ariadne/batch/experiment_page.h"
#include "ariadne/batch/runs_csv.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::experiment_app {

namespace fs = std::filesystem;
using batch::Picture;
using batch::Plot;

namespace {

void make(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

}  // namespace

ResultsOutput::ResultsOutput(const batch::Plan& plan, const batch::Store& store)
    : plan_(plan),
      store_(store),
      results_(store.results(plan)),
      cells_(batch::cellsOf(plan, results_)) {}

std::string ResultsOutput::table(batch::TableFormat format) const {
  return batch::render(batch::tableOf(plan_, cells_, format), format);
}

void ResultsOutput::writePlots() const {
  batch::writePictures(batch::drawPlots(batch::plotsOf(plan_, cells_)), store_.folder() / "plots");
}

std::vector<Picture> ResultsOutput::picturesOr(const std::vector<Plot>& plots,
                                               std::ostream& err) const {
  try {
    return batch::drawPlots(plots);
  } catch (const core::Error& e) {
    fmt::print(err, "ariadne-experiment: no plots: {}; ariadne-experiment report {} draws them\n",
               e.what(), store_.folder().string());
    return {};
  }
}

void ResultsOutput::writeTables(const fs::path& folder) const {
  make(folder);
  for (const auto& [ending, format] :
       {std::pair("txt", batch::TableFormat::text), std::pair("csv", batch::TableFormat::csv),
        std::pair("md", batch::TableFormat::markdown), std::pair("tex", batch::TableFormat::latex)})
    io::writeWhole(folder / fmt::format("table.{}", ending), table(format));
}

void ResultsOutput::exportTo(const fs::path& folder, std::ostream& err) const {
  writeTables(folder);
  io::writeWhole(folder / "runs.csv", batch::runsCsv(plan_, results_));
  const auto pictures = picturesOr(batch::plotsOf(plan_, cells_), err);
  if (!pictures.empty()) make(folder / "plots");
  for (const Picture& picture : pictures)
    io::writeWhole(folder / "plots" / (picture.name + ".svg"), picture.svg);
}

void ResultsOutput::writeReport(std::ostream& err) const {
  const std::vector<Plot> plots = batch::plotsOf(plan_, cells_);
  const std::vector<Picture> pictures = picturesOr(plots, err);
  batch::writePictures(pictures, store_.folder() / "plots");
  io::writeWhole(store_.folder() / "report.html",
                 batch::experimentPage({plan_, results_, cells_, plots, pictures}, store_));
}

}  // namespace ariadne::experiment_app
