// A CSV file that grows by a row a run and goes on after a stop.
#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace ariadne::loops_app {

class RowFile {
 public:
  /// Reads what is there. Throws core::Error naming the file when that has another header.
  RowFile(std::filesystem::path file, const std::string& header);

  /// Whether there is a row of this drive, number of laps and seed, its first three cells.
  bool has(const std::string& run) const { return runs_.count(run) > 0; }
  /// Writes the whole file anew, so that it never holds half a row.
  void add(const std::string& row);

 private:
  std::filesystem::path file_;
  std::string text_;
  std::set<std::string> runs_;
};

}  // namespace ariadne::loops_app
