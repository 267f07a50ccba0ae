#include <gtest/gtest.h>

#include <chrono>

#include "../sim/expect_error.h"
#include "ariadne/io/whole_file.h"
#include "ariadne/io/yaml.h"
#include "temporary_folder.h"

using namespace ariadne;
using io::parseYaml;
using test::expectError;

namespace {

void expectRefused(const std::string& text, const std::vector<std::string>& parts) {
  expectError<core::Error>([&] { parseYaml(text, "a.yaml"); }, parts);
}

/// ASCII as UTF-16 with its byte order mark.
std::string utf16(const std::string& text, bool big_endian) {
  std::string out = big_endian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) {
    const char pair[2] = {big_endian ? '\0' : c, big_endian ? c : '\0'};
    out.append(pair, 2);
  }
  return out;
}

}  // namespace

TEST(Yaml, IsReadInEveryStyleAndCoding) {
  const std::string block =
      "# a map\nimage: \"my map #1.pgm\"  # beside\norigin:\n- -3.5\n-   2\n- 0\ndeep:\n  a:\n"
      "    - {b: +0.5}\n";
  const std::string flow =
      "{image: 'my map #1.pgm', origin: [-3.5, 2, 0], deep: {a: [{b: 5e-1}]}}\n";
  std::string crlf;
  for (const char c : block) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& text :
       {block, flow, crlf, "\xef\xbb\xbf" + crlf, "---\n" + block, utf16(block, false),
        utf16(crlf, true), utf16(flow, true).substr(2)}) {
    const auto yaml = parseYaml(text, "a.yaml");
    EXPECT_EQ(yaml.at("image", "").text(), "my map #1.pgm");
    const auto origin = yaml.at("origin", "");
    ASSERT_EQ(origin.size(), 3U);
    EXPECT_EQ(origin[0].number(-10, 10), -3.5);
    EXPECT_EQ(origin[1].number(-10, 10), 2);
    EXPECT_EQ(yaml.at("deep", "").at("a", "")[0].at("b", "").number(0, 1), 0.5);
    EXPECT_FALSE(yaml.find("mode"));
  }
}

TEST(Yaml, WordsOfFlags) {
  for (const char* yes : {"1", "true", "True", "yes", "on"})
    EXPECT_TRUE(parseYaml(yes, "a.yaml").flag()) << yes;
  for (const char* no : {"0", "false", "FALSE", "no", "off"})
    EXPECT_FALSE(parseYaml(no, "a.yaml").flag()) << no;
}

TEST(Yaml, ErrorsNameFileLineKeyAndWhatWouldBeRight) {
  const auto yaml = parseYaml("a: 1\nb: [0, .nan, x, 1e999]\nc:\n", "m/a.yaml");
  const auto refused = [](auto call, const std::vector<std::string>& parts) {
    expectError<core::Error>(call, parts);
  };
  refused([&] { yaml.at("resolution", "resolution: 0.05"); },
          {"m/a.yaml:1: resolution is missing, as in resolution: 0.05; there are a, b, c"});
  refused([&] { yaml.at("a", "").number(2, 3); },
          {"m/a.yaml:1: a: \"1\"; takes a number from 2 to 3"});
  for (const std::size_t i : {1U, 2U, 3U})
    refused([&] { yaml.at("b", "")[i].number(-1e300, 1e300); },
            {"m/a.yaml:2: b[" + std::to_string(i) + "]: \"", "takes a number"});
  refused([&] { yaml.at("b", "").text(); }, {"b: a list where a text belongs"});
  refused([&] { yaml.at("b", "")[4]; }, {"b: it has 4 values, not 5"});
  refused([&] { yaml.at("c", "").number(0, 1); }, {"m/a.yaml:3: c: nothing; takes a number"});
  refused([&] { yaml.at("a", "").size(); }, {"a: \"1\" where a list belongs"});
  refused([&] { yaml.at("a", "").find("x"); }, {"a: \"1\" where lines of key: value belong"});
  refused([&] { yaml.at("a", "").at("x", ""); }, {"lines of key: value belong"});
  refused([&] { yaml.at("b", "")[0].at("x", ""); }, {"b[0]: "});
  refused([&] { parseYaml("2", "a").flag(); }, {"a:1: \"2\"; takes 0, 1, true or false"});
}

TEST(Yaml, WhatIsNoneIsRefused) {
  expectRefused("a: [1\nb: 2\n", {"a.yaml:", "this is no YAML"});
  expectRefused("a: 1\n\tb: 2\n", {"a.yaml:2: this is no YAML"});
  expectRefused("", {"a.yaml: there is nothing in it"});
  expectRefused("# only this\n", {"a.yaml: there is nothing in it"});
  expectRefused("a: 1\nb: 2\na: 3\n", {"a.yaml:3: a comes twice, first in line 1"});
  expectRefused("a: 1\n---\nb: 2\n", {"a.yaml:2: a second document"});
  expectRefused("[a, b]: 1\n", {"a.yaml:1: a list or a mapping as a key"});
  expectRefused("a: 1\nb: \x04 2\n", {"a.yaml:2: the byte 0x04"});
  expectRefused(utf16("a: 1\nb: \x04 2\n", true), {"a.yaml:2: the byte 0x04"});
  expectRefused(std::string("a\0: 1\n", 6), {"a.yaml:1: the byte 0x00"});
  expectRefused("a: *b\n", {"a.yaml:1: this is no YAML"});
  expectRefused("%eag: \x1e\x03\x19\xe3\xa0\xff\x7f", {"a.yaml:1"});  // MRPT hung on these bytes
}

TEST(Yaml, AnAliasIsAnotherNameOfTheSameValue) {
  const auto yaml = parseYaml("a: &r 0.05\nb: *r\n", "a.yaml");
  EXPECT_EQ(yaml.at("b", "").number(0, 1), 0.05);
  expectRefused("a: &a [1, *a]\n", {"an alias of the value that it stands in"});
}

TEST(Yaml, NothingGrowsBeyondItsBytes) {
  // Ten times ten times ..: 1e30 values if they were copied out.
  std::string bomb = "a0: &a0 [x]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int k = 1; k < 10; ++k) bomb += ", " + before;
    bomb += "]\n";
  }
  EXPECT_EQ(parseYaml(bomb, "a.yaml").at("a29", "").size(), 10U);
  std::string chain = "- &a0 [x]\n";
  for (int i = 1; i < 1000; ++i)
    chain += "- &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + "]\n";
  expectRefused(chain, {"a.yaml:", "over 50 levels"});
  expectRefused(std::string(60, '[') + std::string(60, ']'), {"a.yaml:1: over 50 levels"});
  std::string many = "[";
  for (int i = 0; i < 100001; ++i) many += "1,";
  expectRefused(many + "]", {"over 100000 values"});
}

class YamlFile : public TemporaryFolder {};

TEST_F(YamlFile, IsNamedInErrors) {
  expectError<core::Error>([&] { io::readYaml(folder / "none.yaml"); }, {"none.yaml", "No such"});
  expectError<core::Error>([&] { io::readYaml(folder); }, {folder.string(), "directory"});
  io::writeWhole(folder / "large.yaml", std::string(5 << 20, '#'));
  expectError<core::Error>([&] { io::readYaml(folder / "large.yaml"); },
                           {"large.yaml", "more than 4 MB"});
  expectError<core::Error>([&] { io::readYaml("/dev/zero"); }, {"/dev/zero", "more than 4 MB"});
}
