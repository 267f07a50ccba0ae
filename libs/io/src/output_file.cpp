#include "output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "ariadne/core/error.h"

namespace ariadne::io {

OutputFile::OutputFile(const std::filesystem::path& temporary, std::filesystem::path path,
                       bool compress)
    : path_(std::move(path)), file_(gzopen(temporary.c_str(), compress ? "wb" : "wbT")) {
  if (file_ == nullptr) fail(errno);
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) gzclose(file_);
}

void OutputFile::fail(int code) const {
  throw core::Error(fmt::format("cannot write {}: {}", path_.string(),
                                code != 0 ? std::strerror(code) : "compression failed"));
}

void OutputFile::write(std::string_view bytes) {
  constexpr std::size_t kBlock = 1 << 20;
  while (!bytes.empty()) {
    const std::string_view block = bytes.substr(0, kBlock);
    errno = 0;
    if (gzwrite(file_, block.data(), static_cast<unsigned>(block.size())) <= 0) fail(errno);
    bytes.remove_prefix(block.size());
  }
}

void OutputFile::close() {
  errno = 0;
  if (gzclose(std::exchange(file_, nullptr)) != Z_OK) fail(errno);
}

}  // namespace ariadne::io
