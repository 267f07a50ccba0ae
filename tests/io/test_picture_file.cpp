#include <gtest/gtest.h>

#include "../sim/expect_error.h"
#include "ariadne/core/error.h"
#include "ariadne/io/picture_file.h"
#include "ariadne/io/whole_file.h"
#include "png_bytes.h"
#include "temporary_folder.h"

using namespace ariadne;
using test::expectError;
using test::pngBytes;
using test::PngKind;
using Bytes = std::vector<std::uint8_t>;

namespace {

class PictureFile : public TemporaryFolder {
 protected:
  io::PicturePixels read(const char* name, const std::string& bytes) const {
    io::writeWhole(folder / name, bytes);
    return io::readPicture(folder / name);
  }
  void refused(const char* name, const std::string& bytes, const char* why) const {
    expectError<core::Error>([&] { read(name, bytes); }, {name, why});
  }
};

std::string text(const char* letters, std::size_t count) { return {letters, count}; }

/// Little-endian, as in a BMP.
std::string number(std::uint64_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xffU);
  return out;
}

/// 2 x 1 pixels of 32 bits with an alpha mask, as BITMAPV4HEADER has it.
std::string bmpWithAlpha(const std::string& pixels) {
  std::string header = number(108, 4) + number(2, 4) + number(1, 4) + number(1, 2) + number(32, 2) +
                       number(3, 4) + number(8, 4) + number(2835, 4) + number(2835, 4) +
                       number(0, 8) + number(0xff0000, 4) + number(0xff00, 4) + number(0xff, 4) +
                       number(0xff000000, 4) + "BGRs";
  header.resize(108, '\0');
  return "BM" + number(static_cast<std::uint32_t>(14 + 108 + pixels.size()), 4) + number(0, 4) +
         number(14 + 108, 4) + header + pixels;
}

}  // namespace

TEST_F(PictureFile, GrayIsTheMeanOfTheColours) {
  EXPECT_EQ(read("a.png", pngBytes(3, {}, {{0, 100, 255}})).shade, (Bytes{0, 100, 255}));
  EXPECT_EQ(read("a.png", pngBytes(2, {PNG_COLOR_TYPE_RGB}, {{255, 0, 0, 10, 20, 60}})).shade,
            (Bytes{85, 30}));
  EXPECT_EQ(read("a.pgm", text("P5\n3 2\n255\n\1\2\3\4\5\6", 17)).shade, (Bytes{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(read("a.pgm", "P2\n# c\n2 1\n255\n7 200\n").shade, (Bytes{7, 200}));
  EXPECT_EQ(read("a.pbm", "P1\n3 1\n1 0 1\n").shade, (Bytes{0, 255, 0}));
  EXPECT_EQ(read("a.ppm", text("P6\n1 1\n255\n\12\24\74", 14)).shade, (Bytes{30}));
  EXPECT_EQ(read("a.pgm", text("P5\n2 1\n65535\n\x12\x34\xff\xff", 17)).shade, (Bytes{0x12, 255}));
}

TEST_F(PictureFile, TransparencyInEachForm) {
  const auto gray = read("a.png", pngBytes(3, {PNG_COLOR_TYPE_GRAY_ALPHA}, {{9, 255, 8, 0, 7, 9}}));
  EXPECT_EQ(gray.shade, (Bytes{9, 8, 7}));
  EXPECT_EQ(gray.alpha, (Bytes{255, 0, 9}));
  EXPECT_TRUE(gray.opaque(0));
  EXPECT_FALSE(gray.opaque(1));
  EXPECT_FALSE(gray.opaque(2));
  const auto colour =
      read("a.png", pngBytes(2, {PNG_COLOR_TYPE_RGB_ALPHA}, {{30, 30, 30, 255, 90, 90, 90, 0}}));
  EXPECT_EQ(colour.shade, (Bytes{30, 90}));
  EXPECT_EQ(colour.alpha, (Bytes{255, 0}));
  PngKind palette{PNG_COLOR_TYPE_PALETTE, 4};
  palette.more = [](png_structp png, png_infop info) {
    const png_color colours[3] = {{1, 1, 1}, {200, 200, 200}, {254, 254, 254}};
    const png_byte alphas[2] = {255, 0};
    png_set_PLTE(png, info, colours, 3);
    png_set_tRNS(png, info, alphas, 2, nullptr);
  };
  const auto of_palette = read("a.png", pngBytes(3, palette, {{0x01, 0x20}}));
  EXPECT_EQ(of_palette.shade, (Bytes{1, 200, 254}));
  EXPECT_EQ(of_palette.alpha, (Bytes{255, 0, 255}));
  PngKind one_gray;
  one_gray.more = [](png_structp png, png_infop info) {
    png_color_16 transparent{};
    transparent.gray = 205;
    png_set_tRNS(png, info, nullptr, 0, &transparent);
  };
  EXPECT_EQ(read("a.png", pngBytes(3, one_gray, {{0, 205, 254}})).alpha, (Bytes{255, 0, 255}));
  EXPECT_TRUE(read("a.png", pngBytes(1, {}, {{0}})).alpha.empty());
}

TEST_F(PictureFile, BitsAndInterlacing) {
  EXPECT_EQ(read("a.png", pngBytes(8, {PNG_COLOR_TYPE_GRAY, 1}, {{0xa0}})).shade,
            (Bytes{255, 0, 255, 0, 0, 0, 0, 0}));
  EXPECT_EQ(read("a.png", pngBytes(2, {PNG_COLOR_TYPE_GRAY, 16}, {{0x80, 0x80, 0xff, 0xff}})).shade,
            (Bytes{0x80, 255}));
  std::vector<Bytes> rows;
  Bytes all;
  for (std::uint8_t y = 0; y < 9; ++y) {
    rows.emplace_back();
    for (std::uint8_t x = 0; x < 11; ++x)
      rows.back().push_back(static_cast<std::uint8_t>(20 * y + x));
    all.insert(all.end(), rows.back().begin(), rows.back().end());
  }
  EXPECT_EQ(read("a.png", pngBytes(11, {PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_ADAM7}, rows)).shade,
            all);
}

TEST_F(PictureFile, OfABmpAlphaCountsWhereItIsUsed) {
  const auto some = read("a.bmp", bmpWithAlpha(text("\x1e\x1e\x1e\xff\x5a\x5a\x5a\0", 8)));
  EXPECT_EQ(some.shade, (Bytes{30, 90}));
  EXPECT_TRUE(some.opaque(0));
  EXPECT_FALSE(some.opaque(1));
  const auto none = read("a.bmp", bmpWithAlpha(text("\x1e\x1e\x1e\0\x5a\x5a\x5a\0", 8)));
  EXPECT_EQ(none.shade, (Bytes{30, 90}));
  EXPECT_TRUE(none.opaque(1));
}

TEST_F(PictureFile, WhatIsNoneIsNamed) {
  expectError<core::Error>([&] { io::readPicture(folder / "none.png"); }, {"none.png", "No such"});
  refused("a.png", "no picture", "it is no PNG, PGM");
  refused("a.pgm", "", "it is no PNG, PGM");
  std::string png = pngBytes(200, {}, std::vector<Bytes>(200, Bytes(200, 77)));
  refused("a.png", png.substr(0, png.size() - 30), "it is damaged");
  png[45] ^= 1;
  refused("a.png", png, "it is damaged");
  refused("a.pgm", text("P5\n2 1\n100\n\x32\x64", 13), "brightest value is 100; takes 255");
  refused("a.pgm", "P5\n9 9\n255\n12345", "cannot be decoded");
  refused("a.bmp", "BM" + std::string(60, 'x'), "a.bmp");
}
