// A file, gzip or not, as a window that slides over its unpacked bytes. Text is plain in it:
// without a byte order mark, UTF-16 as UTF-8. It is decoded block by block here, since a log of
// any size is read through this window and no reader of lines need know of encodings; no binary
// format that is read begins like such a text.
#pragma once
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "ariadne/core/plain_text.h"

namespace ariadne::io {

class InputFile {
 public:
  /// Throws core::Error when it cannot be opened or read at all.
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// At least `count` bytes from here on, fewer at the end of the file.
  std::string_view peek(std::size_t count);
  /// Goes on by `count` bytes that were peeked at.
  void skip(std::size_t count) { begin_ += count; }
  /// The next line without its end; false at the end of the file. Of a line that is longer than
  /// 1 MiB only a piece is given, and `too_long` is set.
  bool line(std::string_view& out, bool& too_long);

  /// Unpacked bytes before this point.
  std::uint64_t offset() const { return end_offset_ - (window_.size() - begin_); }
  /// Share of the packed file that the bytes before this point came from.
  double fraction() const;
  /// Why the bytes ended early (damaged compression, a failing disk); empty when they did not.
  const std::string& trouble() const { return trouble_; }

 private:
  bool more();
  int fill();
  void makePlain(std::size_t from);

  std::filesystem::path path_;
  std::uintmax_t packed_size_;
  gzFile file_;
  std::string window_;
  std::unique_ptr<core::TextDecoder> decoder_;
  std::string decoded_;
  bool started_ = false;
  char line_end_ = '\0';  ///< known with the first line
  std::size_t begin_ = 0;
  std::uint64_t end_offset_ = 0;
  std::size_t last_block_ = 0;
  z_off_t packed_before_ = 0, packed_after_ = 0;  ///< the last block came from between
  bool at_end_ = false;
  std::string trouble_;
};

}  // namespace ariadne::io
