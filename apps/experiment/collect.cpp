#include "collect.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>
#include <ostream>
#include <utility>

#include "ariadne/batch/run_counts.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "results_output.h"

namespace ariadne::experiment_app {

int collect(const batch::Plan& plan, const batch::Store& store, std::ostream& out,
            std::ostream& err) {
  const ResultsOutput results(plan, store);
  const batch::Counts counts = batch::countRuns(plan, results.results());
  if (counts.missing() > 0) {
    fmt::print(err,
               "ariadne-experiment: {} of {} runs have no result yet: see ariadne-experiment "
               "status {}; submit again "
               "hands out what nobody does, table shows what there is\n",
               counts.missing(), counts.planned, store.folder().string());
    return 1;
  }
  const auto folder = store.folder() / "tables";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  for (const auto& [ending, format] :
       {std::pair("txt", batch::TableFormat::text), std::pair("csv", batch::TableFormat::csv),
        std::pair("md", batch::TableFormat::markdown),
        std::pair("tex", batch::TableFormat::latex)}) {
    const std::string text = results.table(format);
    io::writeWhole(folder / fmt::format("table.{}", ending), text);
    if (format == batch::TableFormat::text) out << text;
  }
  results.writeReport(err);
  if (counts.failed > 0)
    fmt::print(err,
               "ariadne-experiment: {} runs failed: submit with --again-failed does them again\n",
               counts.failed);
  return counts.failed > 0 ? 1 : 0;
}

}  // namespace ariadne::experiment_app
