#include "results_output.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>

#include "ariadne/batch/experiment_page.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::experiment_app {

using batch::Picture;
using batch::Plot;

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

void ResultsOutput::writeReport(std::ostream& err) const {
  const std::vector<Plot> plots = batch::plotsOf(plan_, cells_);
  std::vector<Picture> pictures;
  try {
    pictures = batch::drawPlots(plots);
  } catch (const core::Error& e) {
    fmt::print(err, "ariadne-experiment: no plots: {}; ariadne-experiment report {} draws them\n",
               e.what(), store_.folder().string());
  }
  batch::writePictures(pictures, store_.folder() / "plots");
  io::writeWhole(store_.folder() / "report.html",
                 batch::experimentPage({plan_, results_, cells_, plots, pictures}, store_));
}

}  // namespace ariadne::experiment_app
