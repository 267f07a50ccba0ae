// Counts as sentences.
#pragma once
#include "ariadne/io/dataset.h"
#include "ariadne/io/dataset_records.h"

namespace ariadne::io {

/// One line a kind of trouble, none for what did not happen.
std::vector<std::string> datasetWarnings(const DatasetCounts& counts, const RecordSource& records);

}  // namespace ariadne::io
