#include "collect.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>

#include "ariadne/batch/run_counts.h"
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
  results.writeTables(store.folder() / "tables");
  out << results.table(batch::TableFormat::text);
  results.writeReport(err);
  if (counts.failed > 0)
    fmt::print(err,
               "ariadne-experiment: {} runs failed: submit with --again-failed does them again\n",
               counts.failed);
  return counts.failed > 0 ? 1 : 0;
}

}  // namespace ariadne::experiment_app
