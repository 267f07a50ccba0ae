// Where temporary files lie: guessable names in /tmp can be taken by others, who then choose what
// is read or overwritten.
#pragma once
#include <filesystem>
#include <string>

namespace ariadne::io {

/// A new folder of this process's user alone (mkdtemp) where the system keeps such, gone with this.
class ScratchFolder {
 public:
  /// @param what names it for who finds it left behind: ariadne-WHAT-XXXXXX
  /// Throws core::Error naming the path when it cannot be made.
  explicit ScratchFolder(const std::string& what);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Absolute.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace ariadne::io
