// Texts as editors and spreadsheets save them, made plain: UTF-8 without a byte order mark. Every
// reader of a text file goes through here.
#pragma once
#include <iconv.h>

#include <memory>
#include <string>
#include <string_view>

namespace ariadne::core {

/// What the first bytes of a file say of its text.
struct TextStart {
  std::size_t mark = 0;  ///< bytes of the byte order mark
  const char* charset =
      nullptr;  ///< UTF-16 or UTF-32 as iconv calls it; nullptr: bytes as they are
};
/// Known by the mark; UTF-16 without one by two characters of ASCII, each with its zero byte. No
/// binary format that is read here begins like that.
TextStart startOfText(std::string_view first_bytes);

/// UTF-16 or UTF-32, piece by piece. What is no character becomes '?'.
class TextDecoder {
 public:
  /// Throws core::Error when the system has no table for `charset`.
  explicit TextDecoder(const char* charset);
  /// Appends what the bytes say, UTF-8; a character that is not complete waits for the next piece.
  void decode(std::string_view bytes, std::string& out);
  /// The end of the file: appends '?' when a character was not complete.
  void finish(std::string& out);

 private:
  struct Close {
    void operator()(void* converter) const { iconv_close(converter); }
  };
  std::unique_ptr<void, Close> converter_;
  std::string waiting_;
  std::size_t unit_;  ///< bytes to pass over where they are no character
};

/// What ends a line: '\r' in a text without any '\n', as old Macs and some spreadsheets write it.
char lineEnd(std::string_view beginning);

/// A whole file's text; "\r\n" and a lone lineEnd() become "\n".
std::string plainText(std::string bytes);

}  // namespace ariadne::core
