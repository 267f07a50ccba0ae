#include "ariadne/io/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "ariadne/core/error.h"
#include "ariadne/core/plain_text.h"

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

core::Error failure(const char* verb, const fs::path& path, int code) {
  return core::Error(fmt::format("cannot {} {}: {}", verb, path.string(), std::strerror(code)));
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  /// Network and quota errors may show up only here.
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

/// Removes the temporary unless it was renamed.
struct Temporary {
  fs::path path;
  bool renamed = false;
  ~Temporary() {
    std::error_code ignored;
    if (!renamed) fs::remove(path, ignored);
  }
};

fs::path temporaryName(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.part{}", path.stem().string(), writerMark(),
                                          path.extension().string());
}

}  // namespace

std::string startOf(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream fields(text.substr(name_end + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) fields >> field;
  return field;
}

std::string writerMark() {
  const std::string pid = std::to_string(::getpid());
  return pid + "-" + startOf(pid);
}

void writeWhole(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  // Renaming over a device would replace it.
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw core::Error(fmt::format("cannot write {}: it is no regular file", path.string()));
  const fs::path name = temporaryName(path);
  {
    // Others may write into the folder: what stands there under this name is theirs.
    Descriptor file(name, O_WRONLY | O_CREAT | O_EXCL);
    if (file.get() < 0) throw failure("write", path, errno);
  }
  Temporary temporary{name};
  write(temporary.path);
  {
    // A full disk may let every write pass and fail only when the pages go out.
    Descriptor file(temporary.path, O_RDONLY);
    if (file.get() < 0 || ::fsync(file.get()) != 0) throw failure("write", path, errno);
  }
  if (::rename(temporary.path.c_str(), path.c_str()) != 0) throw failure("write", path, errno);
  temporary.renamed = true;
}

void writeWhole(const fs::path& path, std::string_view content) {
  writeWhole(path, [&](const fs::path& temporary) {
    Descriptor file(temporary, O_WRONLY | O_TRUNC);
    if (file.get() < 0) throw failure("write", path, errno);
    while (!content.empty()) {
      const ssize_t written = ::write(file.get(), content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw failure("write", path, errno);
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    if (!file.close()) throw failure("write", path, errno);
  });
}

std::string readWhole(const fs::path& path, std::size_t most_bytes) {
  Descriptor file(path, O_RDONLY);
  if (file.get() < 0) throw failure("read", path, errno);
  std::string content;
  char block[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file.get(), block, sizeof(block));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw failure("read", path, errno);
    if (got == 0) return content;
    content.append(block, static_cast<std::size_t>(got));
    if (content.size() > most_bytes)
      throw core::Error(fmt::format("{} holds more than {:.0f} MB, too much for what it is to be",
                                    path.string(), static_cast<double>(most_bytes) / (1 << 20)));
  }
}

std::string readText(const fs::path& path, std::size_t most_bytes) {
  return core::plainText(readWhole(path, most_bytes));
}

}  // namespace ariadne::io
