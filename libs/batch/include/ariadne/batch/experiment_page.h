// report.html of an experiment: one file for a browser, without network or scripts.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/plots.h"
#include "ariadne/batch/store.h"
#include "ariadne/batch/tables.h"

namespace ariadne::batch {

/// What the results have come to.
struct Outcome {
  const Plan& plan;
  const std::map<std::string, RunResult>& results;
  const std::vector<Cell>& cells;
  const std::vector<Plot>& plots;
  const std::vector<Picture>& pictures;  ///< of the plots; empty when they could not be drawn
};

/// The page, under 10 MB: of lists that are too long the first, and how many are left out. Links to
/// single runs' pages are relative to the results folder.
/// @param store for resolved INIs and to see which runs' pages were kept
/// Throws core::Error when an INI cannot be read.
std::string experimentPage(const Outcome& outcome, const Store& store);

}  // namespace ariadne::batch
