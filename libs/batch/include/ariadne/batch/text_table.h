// A table of texts in four formats.
#pragma once
#include <string>
#include <vector>

namespace ariadne::batch {

struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  ///< below; not in CSV
};

enum class TableFormat { text, csv, markdown, latex };

std::string render(const TextTable& table, TableFormat format);

}  // namespace ariadne::batch
