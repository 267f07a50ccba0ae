#include "ariadne/process/share_read.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace ariadne::process {
namespace {

namespace fs = std::filesystem;

/// Bytes from the start, of an open file's /proc/PID/fdinfo/N.
std::optional<double> positionIn(const fs::path& fdinfo) {
  std::ifstream in(fdinfo);
  std::string word;
  double position = 0;
  if (in >> word >> position && word == "pos:") return position;
  return std::nullopt;
}

}  // namespace

std::optional<double> shareRead(pid_t pid, const fs::path& file) {
  std::error_code error;
  const fs::path wanted = fs::canonical(file, error);
  const auto size = static_cast<double>(fs::file_size(wanted, error));
  const fs::path process = "/proc/" + std::to_string(pid);
  if (error || size <= 0) return std::nullopt;
  std::optional<double> share;
  // The process may close files or end at any moment: whatever is gone by then is passed over.
  for (auto fd = fs::directory_iterator(process / "fd", error);
       !error && fd != fs::directory_iterator(); fd.increment(error)) {
    std::error_code gone;
    if (fs::read_symlink(fd->path(), gone) != wanted) continue;
    if (const auto position = positionIn(process / "fdinfo" / fd->path().filename()))
      share = std::max(share.value_or(0), std::min(*position / size, 1.0));
  }
  return share;
}

}  // namespace ariadne::process
