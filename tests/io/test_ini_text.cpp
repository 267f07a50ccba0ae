#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

using ariadne::core::UsageError;
using ariadne::io::IniDialect;
using ariadne::io::parseIni;

namespace {

std::string complaint(std::string_view text) {
  try {
    parseIni(text, "a.ini", IniDialect::strict);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

std::string onlyValue(const std::string& line, IniDialect dialect = IniDialect::strict) {
  const auto document = parseIni("[s]\n" + line, "a.ini", dialect);
  return document.entries.size() == 1 ? document.entries[0].value : "?";
}

}  // namespace

TEST(IniText, TakesWhatEditorsMake) {
  const auto document =
      parseIni("; first\r\n# second\r\n// third\r\n\r\n  [ grid ] // c\r\n\t a=1 ; x\r\n b = 2",
               "a.ini", IniDialect::strict);
  ASSERT_EQ(document.entries.size(), 2U);
  EXPECT_EQ(document.sections[0].name, "grid");
  EXPECT_EQ(document.entries[0].key, "a");
  EXPECT_EQ(document.entries[0].value, "1");
  EXPECT_EQ(document.entries[0].where, "a.ini:6");
  EXPECT_EQ(document.entries[1].value, "2");
}

TEST(IniText, CommentsStartAfterABlank) {
  EXPECT_EQ(onlyValue("k = a//b;c#d // e"), "a//b;c#d");
  EXPECT_EQ(onlyValue("k = ; nothing"), "");
  EXPECT_EQ(onlyValue("k = \"a ; b\" ; c"), "a ; b");
  EXPECT_EQ(onlyValue("k = a=b"), "a=b");
  EXPECT_EQ(onlyValue("k = 5 ; x", IniDialect::mrpt), "5 ; x");
  EXPECT_EQ(onlyValue("k = 5 // x", IniDialect::mrpt), "5");
  EXPECT_EQ(onlyValue("k = 0.10// x", IniDialect::mrpt), "0.10// x");
}

TEST(IniText, SaysWhereAndWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[a]\nk=1\n[b]\n[a]\n", "a.ini:4: section [a] comes twice, first in line 1"},
      {"[a]\nk=1\nj=2\nk=3\n", "a.ini:4: [a] k comes twice, first in line 2"},
      {"k=1\n", "a.ini:1: \"k\" stands before any [section]"},
      {"[a]\nhello\n", "a.ini:2: \"hello\" is neither [section] nor key = value"},
      {"[a]\n=3\n", "a.ini:2: \"=3\" is neither"},
      {"[a\n", "a.ini:1: \"[a\" is no [section]"},
      {"[]\n", "a.ini:1: \"[]\" is no [section]"},
      {"[a] b\n", "a.ini:1: something follows"},
      {"[a]\nk = \"x\n", "a.ini:2: no closing quote"},
      {"[a]\nk = \"x\" y\n", "a.ini:2: something follows"},
      {std::string("[a]\nk=\0", 7), "a.ini:2: holds a NUL byte"},
      {"[a]\nk=" + std::string(70000, 'x'), "a.ini:2: the line is longer than 64 KB"},
      {"\x1f\x8b\x08rubbish", "a.ini:1: \"\\x1f\x8b\\x08rubbish\" is neither"}};
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(complaint(text).substr(0, expected.size()), expected) << text.substr(0, 40);
}

TEST(IniText, MrptDialectIsAsLenientAsMrpt) {
  const auto document =
      parseIni("k=0\n[a]\nk=1\nhello\nk=2\n[b\n[a]\nj=3\n", "a.ini", IniDialect::mrpt);
  EXPECT_TRUE(document.hasSection("A"));
  ASSERT_EQ(document.entries.size(), 4U);
  EXPECT_EQ(document.entries[3].section, "a");
}

TEST(IniText, NearestNameCountsEdits) {
  using ariadne::io::nearestName;
  EXPECT_EQ(nearestName("particels", {"seed", "particles", "beta"}), "particles");
  EXPECT_EQ(nearestName("BETA", {"seed", "data", "beta"}), "beta");
  EXPECT_EQ(nearestName("x", {}), "");
  EXPECT_EQ(nearestName(std::string(100000, 'a'), {"ab", "b"}), "ab");
}

TEST(IniText, SettingsAreSectionKeyValue) {
  const auto entry = ariadne::io::parseSetting(" dataset . file = a.b=c ");
  EXPECT_EQ(entry.section, "dataset");
  EXPECT_EQ(entry.key, "file");
  EXPECT_EQ(entry.value, "a.b=c");
  for (const char* bad : {"", "a", "a.b", "a=b", "a=b.c"})
    EXPECT_THROW(ariadne::io::parseSetting(bad), UsageError) << bad;
}

class IniFile : public TemporaryFolder {};

TEST_F(IniFile, WhatIsNoFileOrTooLargeIsAnError) {
  EXPECT_THROW(ariadne::io::readIniText(folder / "none.ini"), ariadne::core::Error);
  EXPECT_THROW(ariadne::io::readIniText(folder), ariadne::core::Error);
  EXPECT_THROW(ariadne::io::readIniText("/dev/zero"), UsageError);
  ariadne::io::writeWhole(folder / "a.ini", std::string_view("[a]\nb=1"));
  EXPECT_EQ(ariadne::io::readIniText(folder / "a.ini"), "[a]\nb=1");
  const std::string_view utf16("\xFF\xFE[\0a\0]\0\r\0\n\0b\0=\0001\0", 18);
  for (const std::string_view text : {std::string_view("\xEF\xBB\xBF[a]\r\nb=1"), utf16}) {
    ariadne::io::writeWhole(folder / "b.ini", text);
    EXPECT_EQ(ariadne::io::readIniText(folder / "b.ini"), "[a]\nb=1");
  }
}

TEST(IniText, MutatedFilesGiveAResultOrAnError) {
  const std::string base = "[a]\r\nk = \"v\" ; c\nj = 2 // x\n\n[b]\nk=#\n";
  for (std::uint32_t round = 0; round < 5000; ++round) {
    ariadne::core::RandomStream random(3, round, 0, ariadne::core::Purpose::test);
    std::string mutant = base;
    for (int k = 0; k < 3; ++k) mutant[random.bits() % mutant.size()] = char(random.bits());
    mutant.resize(random.bits() % mutant.size() + 1);
    complaint(mutant);
    parseIni("[a]\n", "a.ini", IniDialect::mrpt);
  }
}
