// Every reader of text takes what editors and other systems make of a file.
#include <zlib.h>

#include <algorithm>

#include "ariadne/io/relations.h"
#include "ariadne/io/tum.h"
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

namespace {

std::string utf16(const std::string& ascii, bool big_endian, bool mark) {
  std::string bytes;
  const auto add = [&](unsigned unit) {
    bytes += static_cast<char>(big_endian ? unit >> 8 : unit & 0xFF);
    bytes += static_cast<char>(big_endian ? unit & 0xFF : unit >> 8);
  };
  if (mark) add(0xFEFF);
  for (const char c : ascii) add(static_cast<unsigned char>(c));
  return bytes;
}

/// The same text in every encoding, with line ends of either kind.
std::vector<std::string> encodings(const std::string& text) {
  std::string windows, mac = text;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::replace(mac.begin(), mac.end(), '\n', '\r');
  return {"\xEF\xBB\xBF" + text,      "\xEF\xBB\xBF" + windows,
          utf16(text, false, true),   utf16(text, true, true),
          utf16(windows, true, true), utf16(text, false, false),
          utf16(text, true, false),   mac,
          utf16(mac, false, true)};
}

void writePacked(const std::filesystem::path& path, const std::string& bytes) {
  gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
}

}  // namespace

class TextFiles : public TemporaryFolder {};

TEST_F(TextFiles, CarmenLogsInAnyEncoding) {
  const std::string plain = carmenLog(30);
  for (const std::string& bytes : encodings(plain)) {
    const Result r = readBytes(folder / "a.log", bytes);
    EXPECT_EQ(r.steps.size(), 30U) << r.error;
    EXPECT_TRUE(r.warnings.empty()) << r.warnings[0];
    writePacked(folder / "b.log.gz", bytes);
    EXPECT_EQ(read(folder / "b.log.gz").steps.size(), 30U);
  }
  // The first line is a scan, not a comment that a mark may spoil unseen.
  const std::string scans = plain.substr(plain.find("FLASER"));
  for (const std::string& bytes : encodings(scans))
    EXPECT_EQ(readBytes(folder / "c.log", bytes).steps.size(), 30U);
}

TEST_F(TextFiles, AUtf16LogThatEndsWithinACharacterKeepsTheRest) {
  std::string bytes = utf16(carmenLog(30), false, true);
  bytes.resize(bytes.size() - 3);
  EXPECT_EQ(readBytes(folder / "a.log", bytes).steps.size(), 30U);
}

TEST_F(TextFiles, TrajectoriesInAnyEncoding) {
  for (const std::string& bytes :
       encodings("# timestamp tx ty tz qx qy qz qw\n1 3 3 0 0 0 0.7 0.7\n2 3 4 0 0 0 0.7 0.7\n")) {
    io::writeWhole(folder / "a.tum", bytes);
    const auto path = io::readTum(folder / "a.tum");
    ASSERT_EQ(path.size(), 2U);
    EXPECT_EQ(path[1].pose.y, 4);
  }
}

TEST_F(TextFiles, RelationsInAnyEncoding) {
  for (const std::string& bytes : encodings("1 2 0.5 0 0 0 0 0.1\n2 3 0.5 0 0 0 0 0.1\n")) {
    io::writeWhole(folder / "a.relations", bytes);
    EXPECT_EQ(io::readRelations(folder / "a.relations").size(), 2U);
  }
}
