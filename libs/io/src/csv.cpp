#include "ariadne/io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/core/numbers.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::io {
namespace {

/// Rows one after the other; a cell in quotes may hold commas, quotes (twice) and line ends.
class CsvRows {
 public:
  CsvRows(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  bool atEnd() const { return at_ == text_.size(); }
  std::size_t line() const { return line_; }

  std::vector<std::string> next() {
    std::vector<std::string> cells;
    do cells.push_back(cell());
    while (take(','));
    take('\r');
    if (!take('\n') && !atEnd()) fail("something stands behind a cell's closing quote");
    ++line_;
    return cells;
  }

 private:
  bool take(char c) {
    if (atEnd() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  std::string cell() {
    if (take('"')) return quoted();
    const std::size_t end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    const std::size_t begin = std::exchange(at_, end);
    return std::string(text_.substr(begin, end - begin));
  }
  std::string quoted() {
    std::string cell;
    for (; !atEnd(); ++at_) {
      if (text_[at_] == '"' && (at_ + 1 == text_.size() || text_[at_ + 1] != '"')) {
        ++at_;
        return cell;
      }
      if (text_[at_] == '"') ++at_;  // the first of two
      line_ += text_[at_] == '\n';
      cell += text_[at_];
    }
    fail("a quote has no end");
  }
  [[noreturn]] void fail(const char* what) const {
    throw core::Error(fmt::format("{}:{}: {}", name_, line_, what));
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

bool isEmpty(const std::vector<std::string>& cells) {
  return cells.size() == 1 && cells[0].empty();
}

}  // namespace

CsvTable::CsvTable(std::string_view text, std::string name) : name_(std::move(name)) {
  CsvRows rows(text, name_);
  if (!rows.atEnd()) header_ = rows.next();
  while (!rows.atEnd()) {
    const std::size_t line = rows.line();
    Row row{rows.next(), line};
    if (isEmpty(row.cells) && rows.atEnd()) break;
    if (row.cells.size() != header_.size())
      throw core::Error(fmt::format("{}:{}: {} cells; the header has {}", name_, line,
                                    row.cells.size(), header_.size()));
    rows_.push_back(std::move(row));
  }
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end())
    throw core::Error(fmt::format("{}:1: there is no column {}", name_, name));
  return static_cast<std::size_t>(found - header_.begin());
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& cell = rows_[row].cells[column];
  const auto value = core::parseNumber(cell);
  if (!value || !std::isfinite(*value))
    throw core::Error(fmt::format("{}: {}: \"{}\" is no number", place(row), header_[column],
                                  core::printable(cell)));
  return *value;
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", name_, rows_[row].line);
}

CsvTable readCsv(const std::filesystem::path& file) { return {readText(file), file.string()}; }

}  // namespace ariadne::io
