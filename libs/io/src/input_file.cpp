#include "input_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "ariadne/core/error.h"

namespace ariadne::io {
namespace {

// Damaged gzip loses the rest of the block that is being read, so blocks are small.
constexpr std::size_t kBlock = 1 << 14;
constexpr std::size_t kLongestLine = 1 << 20;

core::Error failure(const std::filesystem::path& path, const std::string& why) {
  return core::Error(fmt::format("cannot read {}: {}", path.string(), why));
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) : path_(path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) throw failure(path, "it is a directory");
  packed_size_ = std::filesystem::file_size(path, code);
  if (code) throw failure(path, code.message());
  file_ = gzopen(path.c_str(), "rb");
  if (file_ == nullptr) throw failure(path, std::strerror(errno));
  // zlib unpacks twice as much at once: no more than a block, so that gzoffset is what was used.
  gzbuffer(file_, kBlock / 2);
}

InputFile::~InputFile() { gzclose(file_); }

/// Appends a block of the file to the window; returns its size, 0 at the end and -1 on failure.
int InputFile::fill() {
  const std::size_t old_size = window_.size();
  window_.resize(old_size + kBlock);
  const int got = gzread(file_, window_.data() + old_size, kBlock);
  window_.resize(old_size + static_cast<std::size_t>(std::max(got, 0)));
  packed_before_ = packed_after_;
  packed_after_ = std::max(gzoffset(file_), packed_before_);
  return got;
}

/// What the window holds from there on was read just now.
void InputFile::makePlain(std::size_t from) {
  if (!std::exchange(started_, true)) {
    const core::TextStart start = core::startOfText(window_);
    if (start.charset != nullptr) try {
        decoder_ = std::make_unique<core::TextDecoder>(start.charset);
      } catch (const core::Error& e) {
        throw failure(path_, e.what());
      }
    window_.erase(0, start.mark);
  }
  if (!decoder_) return;
  decoded_.clear();
  decoder_->decode(std::string_view(window_).substr(from), decoded_);
  window_.replace(from, window_.npos, decoded_);
}

bool InputFile::more() {
  if (at_end_) return false;
  window_.erase(0, begin_);
  begin_ = 0;
  const std::size_t old_size = window_.size();
  const int got = fill();
  if (got > 0) {
    makePlain(old_size);
  } else if (decoder_) {
    decoder_->finish(window_);
  }
  last_block_ = window_.size() - old_size;
  end_offset_ += last_block_;
  if (got > 0) return true;
  // Only now: zlib reports an early end long before the last bytes are out.
  at_end_ = true;
  int code = Z_OK;
  const char* text = gzerror(file_, &code);
  if (code == Z_BUF_ERROR) {
    trouble_ = "the compressed data end early";
  } else if (code == Z_ERRNO) {
    trouble_ = std::strerror(errno);
  } else if (code != Z_OK && code != Z_STREAM_END) {
    trouble_ = fmt::format("the compressed data are damaged ({})", text);
  }
  return false;
}

std::string_view InputFile::peek(std::size_t count) {
  while (window_.size() - begin_ < count && more()) {
  }
  return {window_.data() + begin_, window_.size() - begin_};
}

bool InputFile::line(std::string_view& out, bool& too_long) {
  if (line_end_ == '\0') line_end_ = core::lineEnd(peek(kBlock));
  std::size_t searched = 0;
  too_long = false;
  for (;;) {
    const std::string_view here = peek(searched + 1);
    const std::size_t end = here.find(line_end_, searched);
    if (end != here.npos) {
      out = here.substr(0, end);
      skip(end + 1);
      return true;
    }
    if (here.size() == searched) break;  // the end of the file
    searched = here.size();
    if (searched < kLongestLine) continue;
    too_long = true;
    skip(searched);
    searched = 0;
  }
  out = peek(0).substr(0, searched);
  skip(searched);
  return searched > 0 || too_long;
}

double InputFile::fraction() const {
  if (at_end_ && begin_ == window_.size()) return 1;
  if (packed_size_ == 0) return 1;
  // Of a file that is not packed zlib takes a whole buffer at once: our own place is the true one.
  if (gzdirect(file_) != 0)
    return std::clamp(static_cast<double>(offset()) / static_cast<double>(packed_size_), 0.0, 1.0);
  // Of the last block's share of the packed file, as much as was used of the block.
  const std::size_t left = std::min(window_.size() - begin_, last_block_);
  const double used =
      last_block_ == 0 ? 1 : 1 - static_cast<double>(left) / static_cast<double>(last_block_);
  const double done = static_cast<double>(packed_before_) +
                      used * static_cast<double>(packed_after_ - packed_before_);
  return std::clamp(done / static_cast<double>(packed_size_), 0.0, 1.0);
}

}  // namespace ariadne::io
