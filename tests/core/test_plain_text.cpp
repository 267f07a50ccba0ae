// Texts in the encodings that editors offer become the same UTF-8.
#include <gtest/gtest.h>

#include "ariadne/core/plain_text.h"

using ariadne::core::plainText;
using ariadne::core::startOfText;
using ariadne::core::TextDecoder;
using namespace std::string_literals;

namespace {

/// UTF-16 of a text without pairs of surrogates, UTF-32 of any.
std::string wide(const std::u32string& text, std::size_t unit, bool big_endian) {
  std::string bytes;
  for (const char32_t c : text)
    for (std::size_t i = 0; i < unit; ++i) {
      const std::size_t byte = big_endian ? unit - 1 - i : i;
      bytes += static_cast<char>(c >> (8 * byte) & 0xFF);
    }
  return bytes;
}

const std::u32string kText = U"FLASER 3 1.5 Grüße €\n";
const std::string kPlain = "FLASER 3 1.5 Gr\u00fc\u00dfe \u20ac\n";

}  // namespace

TEST(PlainText, EveryEncodingGivesTheSame) {
  EXPECT_EQ(plainText(kPlain), kPlain);
  EXPECT_EQ(plainText("\xEF\xBB\xBF" + kPlain), kPlain);
  for (const bool big : {false, true})
    for (const std::size_t unit : {2U, 4U}) {
      const std::string mark = wide(U"\uFEFF", unit, big);
      EXPECT_EQ(plainText(mark + wide(kText, unit, big)), kPlain) << unit << big;
    }
  EXPECT_EQ(plainText(wide(kText, 2, false)), kPlain);  // no mark
  EXPECT_EQ(plainText(wide(kText, 2, true)), kPlain);
}

TEST(PlainText, LineEndsOfWindowsBecomePlain) {
  EXPECT_EQ(plainText("a\r\nb\r\n"), "a\nb\n");
  EXPECT_EQ(plainText("\xFF\xFE"s + wide(U"a\r\nb\r", 2, false)), "a\nb\r");
}

TEST(PlainText, LoneCarriageReturnsEndLinesWhereNothingElseDoes) {
  EXPECT_EQ(plainText("a\rb\r"), "a\nb\n");
  EXPECT_EQ(plainText("\xFE\xFF"s + wide(U"a\rb", 2, true)), "a\nb");
  EXPECT_EQ(plainText("a\rb\n"), "a\rb\n");
}

TEST(PlainText, OtherBytesStayAsTheyAre) {
  for (const std::string& bytes : {""s, "a"s, "\xEF\xBB"s, "Gr\xFC\xDF"s, "\x89PNG\r\x1a\0\0"s,
                                   "\x11\0\0\0CObservation"s, "a\0b"s, "\x88 end"s})
    EXPECT_EQ(plainText(bytes), bytes);
}

TEST(PlainText, APairOfSurrogatesIsACharacterAndHalfOfOneIsNone) {
  const std::string mark = "\xFF\xFE";
  EXPECT_EQ(plainText(mark + "\x3D\xD8\x00\xDE"s), "\U0001F600");
  EXPECT_EQ(plainText(mark + "a\0\x00\xDE"
                             "b\0"s),
            "a?b");
  EXPECT_EQ(plainText(mark + "a\0\x3D\xD8"
                             "b\0"s),
            "a?b");
  EXPECT_EQ(plainText(mark + "a\0\x3D\xD8"s), "a?");
  EXPECT_EQ(plainText(mark + "a\0b"s), "a?");  // an odd number of bytes
  EXPECT_EQ(plainText(mark), "");
}

TEST(PlainText, PiecesOfAnySizeGiveTheWhole) {
  const std::string bytes = wide(kText, 2, false) + "\x3D\xD8\x00\xDE"s;
  for (std::size_t piece = 1; piece < 9; ++piece) {
    TextDecoder decoder("UTF-16LE");
    std::string out;
    for (std::size_t at = 0; at < bytes.size(); at += piece)
      decoder.decode(std::string_view(bytes).substr(at, piece), out);
    decoder.finish(out);
    EXPECT_EQ(out, kPlain + "\U0001F600") << piece;
  }
}

TEST(PlainText, LongTextsPassTheDecodersBlocks) {
  const std::u32string text(50'000, U'€');
  const std::string plain = plainText("\xFE\xFF" + wide(text, 2, true));
  ASSERT_EQ(plain.size(), 150'000U);
  EXPECT_EQ(plain.substr(149'997), "\u20ac");
}
