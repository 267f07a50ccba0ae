// Columns of a table of cells: medians with their intervals.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ariadne/batch/tables.h"

namespace ariadne::batch {

struct Column {
  std::string name;
  std::function<std::string(const Cell&)> text;
};

/// Of Plan::figures, and the changes from the first arm of Plan::relative.
void addFigures(std::vector<Column>& columns, const Plan& plan, bool csv);

}  // namespace ariadne::batch
