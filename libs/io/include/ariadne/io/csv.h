// Tables of comma-separated values (RFC 4180), as our programs write them.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::io {

/// A table of a CSV file: a header, then rows of as many cells.
class CsvTable {
 public:
  /// Takes cells in quotes, line ends of any system and empty lines at the end. Throws core::Error
  /// behind `name` and the line for a quote without end and for a row that is longer or shorter
  /// than the header.
  CsvTable(std::string_view text, std::string name);

  /// Names of the columns.
  const std::vector<std::string>& header() const { return header_; }
  /// Rows without the header.
  std::size_t size() const { return rows_.size(); }
  /// Cells of row i, from 0.
  const std::vector<std::string>& row(std::size_t i) const { return rows_[i].cells; }
  /// Index of a column. Throws core::Error when there is none of the name.
  std::size_t column(const std::string& name) const;
  /// Throws core::Error naming line and column unless the cell is a finite number.
  double number(std::size_t row, std::size_t column) const;
  /// "steps.csv:3", for errors.
  std::string place(std::size_t row) const;

 private:
  struct Row {
    std::vector<std::string> cells;
    std::size_t line = 0;
  };
  std::string name_;
  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

/// Throws core::Error naming the file, also when it cannot be read.
CsvTable readCsv(const std::filesystem::path& file);

}  // namespace ariadne::io
