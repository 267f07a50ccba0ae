// A file being written, gzip or plain, that reports every failure (MRPT's stream ignores those of
// closing, and so a full disk).
#pragma once
#include <zlib.h>

#include <filesystem>
#include <string_view>

namespace ariadne::io {

class OutputFile {
 public:
  /// Writes to `temporary`; errors name `path`.
  OutputFile(const std::filesystem::path& temporary, std::filesystem::path path, bool compress);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  void write(std::string_view bytes);
  /// Must be called: what is still in buffers may fail to go out.
  void close();

 private:
  [[noreturn]] void fail(int code) const;
  std::filesystem::path path_;
  gzFile file_;
};

}  // namespace ariadne::io
