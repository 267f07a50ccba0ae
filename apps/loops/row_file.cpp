#include "row_file.h"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::loops_app {
namespace {

/// The first three cells.
std::string runOf(const std::string& row) {
  std::size_t end = 0;
  for (int comma = 0; comma < 3 && end != std::string::npos; ++comma)
    end = row.find(',', comma == 0 ? 0 : end + 1);
  return row.substr(0, end);
}

}  // namespace

RowFile::RowFile(std::filesystem::path file, const std::string& header)
    : file_(std::move(file)), text_(header + "\n") {
  std::error_code ignored;
  if (!std::filesystem::exists(file_, ignored)) return;
  std::istringstream there(io::readText(file_));
  std::string line;
  if (!std::getline(there, line) || line != header)
    throw core::Error(
        fmt::format("{}:1: rows of another command or version: take another file", file_.string()));
  while (std::getline(there, line)) {
    text_ += line + "\n";
    runs_.insert(runOf(line));
  }
}

void RowFile::add(const std::string& row) {
  text_ += row + "\n";
  runs_.insert(runOf(row));
  io::writeWhole(file_, text_);
}

}  // namespace ariadne::loops_app
