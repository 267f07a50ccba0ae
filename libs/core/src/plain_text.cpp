#include "ariadne/core/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "ariadne/core/error.h"

namespace ariadne::core {
namespace {

bool isAscii(char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\n' || c == '\r'; }

/// Two characters of ASCII, their zero bytes at `zero` and two bytes further.
bool looksLikeUtf16(std::string_view first_bytes, std::size_t zero) {
  if (first_bytes.size() < 4) return false;
  const std::size_t letter = 1 - zero;
  return first_bytes[zero] == '\0' && first_bytes[zero + 2] == '\0' &&
         isAscii(first_bytes[letter]) && isAscii(first_bytes[letter + 2]);
}

}  // namespace

TextStart startOfText(std::string_view first_bytes) {
  const auto begins = [&](std::string_view with) {
    return first_bytes.substr(0, with.size()) == with;
  };
  using namespace std::string_view_literals;
  if (begins("\xEF\xBB\xBF"sv)) return {3, nullptr};
  if (begins("\xFF\xFE\0\0"sv)) return {4, "UTF-32LE"};
  if (begins("\0\0\xFE\xFF"sv)) return {4, "UTF-32BE"};
  if (begins("\xFF\xFE"sv)) return {2, "UTF-16LE"};
  if (begins("\xFE\xFF"sv)) return {2, "UTF-16BE"};
  if (looksLikeUtf16(first_bytes, 1)) return {0, "UTF-16LE"};
  if (looksLikeUtf16(first_bytes, 0)) return {0, "UTF-16BE"};
  return {};
}

TextDecoder::TextDecoder(const char* charset)
    : unit_(std::string_view(charset).substr(0, 6) == "UTF-32" ? 4 : 2) {
  void* const converter = iconv_open("UTF-8", charset);
  if (converter == reinterpret_cast<void*>(-1))  // NOLINT: iconv's own way to fail
    throw Error(fmt::format("the text is {}, and this system cannot read it ({}); save it as UTF-8",
                            charset, std::strerror(errno)));
  converter_.reset(converter);
}

void TextDecoder::decode(std::string_view bytes, std::string& out) {
  waiting_.append(bytes);
  char* from = waiting_.data();
  std::size_t left = waiting_.size();
  std::array<char, 8192> block{};
  for (bool done = false; !done && left > 0;) {
    char* to = block.data();
    std::size_t room = block.size();
    done = iconv(converter_.get(), &from, &left, &to, &room) != static_cast<std::size_t>(-1);
    const int why = errno;
    out.append(block.data(), static_cast<std::size_t>(to - block.data()));
    if (done || why == E2BIG) continue;
    if (why != EILSEQ || left < unit_) break;  // the rest is a part of a character
    out += '?';
    from += unit_;
    left -= unit_;
  }
  waiting_.erase(0, waiting_.size() - left);
}

void TextDecoder::finish(std::string& out) {
  if (!waiting_.empty()) out += '?';
  waiting_.clear();
}

char lineEnd(std::string_view beginning) {
  const bool other =
      beginning.find('\n') != beginning.npos || beginning.find('\0') != beginning.npos;
  return !other && beginning.find('\r') != beginning.npos ? '\r' : '\n';
}

std::string plainText(std::string bytes) {
  const TextStart start = startOfText(bytes);
  bytes.erase(0, start.mark);
  if (start.charset != nullptr) {
    std::string text;
    TextDecoder decoder(start.charset);
    decoder.decode(bytes, text);
    decoder.finish(text);
    bytes = std::move(text);
  }
  if (lineEnd(bytes) == '\r') std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  constexpr std::string_view kOfWindows = "\r\n";
  const auto line_end =
      std::search(bytes.begin(), bytes.end(), kOfWindows.begin(), kOfWindows.end());
  if (line_end == bytes.end()) return bytes;
  auto to = line_end;
  for (auto from = line_end; from != bytes.end(); ++from)
    if (*from != '\r' || from + 1 == bytes.end() || from[1] != '\n') *to++ = *from;
  bytes.erase(to, bytes.end());
  return bytes;
}

}  // namespace ariadne::core
