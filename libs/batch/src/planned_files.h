// Programs and data as they were when the plan was made: else results would lie under wrong keys.
#pragma once
#include <map>
#include <string>

namespace ariadne::batch {

class PlannedFiles {
 public:
  /// @param files with their hashes, of the plan; must outlive this
  explicit PlannedFiles(const std::map<std::string, std::string>& files) : files_(files) {}

  /// Throws core::Error for a file that is not what it was. Reads those only of which size, time or
  /// inode is another than at the last call.
  void check();

 private:
  const std::map<std::string, std::string>& files_;
  std::map<std::string, std::string> stamps_;
};

}  // namespace ariadne::batch
