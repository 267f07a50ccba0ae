// A table of texts in four formats.
#pragma once
#include <string>
#include <vector>

namespace ariadne::batch {

/// A table of texts, to be printed, or written as Markdown, CSV or HTML.
struct TextTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  ///< below; not in CSV
};

/// How a table is written.
enum class TableFormat { text, csv, markdown, latex };

/// The table as text that ends with a line's end.
std::string render(const TextTable& table, TableFormat format);

}  // namespace ariadne::batch
