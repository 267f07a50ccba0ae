#include "ariadne/io/scratch_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "ariadne/core/error.h"

namespace ariadne::io {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const std::string& what) {
  std::error_code error;
  const fs::path around = fs::temp_directory_path(error);
  if (error) throw core::Error("there is no folder for temporary files: " + error.message());
  std::string name = (around / ("ariadne-" + what + "-XXXXXX")).string();
  if (!::mkdtemp(name.data()))
    throw core::Error(fmt::format("cannot make the folder {}: {}", name, std::strerror(errno)));
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace ariadne::io
