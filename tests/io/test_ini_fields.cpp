#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "ariadne/core/random.h"
#include "ariadne/io/ini_fields.h"
#include "ariadne/io/ini_writer.h"
#include "ariadne/slam/params.h"

namespace {

using ariadne::core::UsageError;
using ariadne::io::IniDialect;
using ariadne::slam::SlamParams;

enum class Colour { red, green };

struct Things {
  double share = 0.5;
  double anything = 1;
  int count = 3;
  std::uint64_t seed = 1;
  bool quick = false;
  std::string name;
  Colour colour = Colour::red;
};

template <class V>
void visitFields(V& v, Things& p) {
  v.number("share", p.share, {0, 1}, "a share");
  v.number("anything", p.anything, {}, "a number");
  v.number("count", p.count, {1, 10}, "a count");
  v.number("seed", p.seed, {0, 9007199254740992.0}, "a seed");
  v.flag("quick", p.quick, "a flag");
  v.text("name", p.name, "a text");
  v.choice("colour", p.colour,
           ariadne::core::Choices<Colour>{{"red", Colour::red}, {"green", Colour::green}},
           "a choice");
}

struct Others {
  double weight = 1;
};

template <class V>
void visitFields(V& v, Others& p) {
  v.number("weight", p.weight, {0, 9}, "a weight");
}

struct Config {
  Things things;
  Others others;
};

template <class C, class F>
void forEachSection(C& c, F&& f) {
  f("things", c.things);
  f("others", c.others);
}

Config readConfig(const std::string& text) {
  Config config;
  applyIni(config, ariadne::io::parseIni(text, "a.ini", IniDialect::strict));
  return config;
}

std::string fieldComplaint(const std::string& text) {
  try {
    readConfig(text);
  } catch (const UsageError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(IniFields, SetsWhatIsNamedAndLeavesTheRest) {
  const Config c =
      readConfig("[things]\ncount = 7\nquick = on\nname = a b\ncolour = green\nshare=+.25\n");
  EXPECT_EQ(c.things.count, 7);
  EXPECT_TRUE(c.things.quick);
  EXPECT_EQ(c.things.name, "a b");
  EXPECT_EQ(c.things.colour, Colour::green);
  EXPECT_EQ(c.things.share, 0.25);
  EXPECT_EQ(c.things.anything, 1);
}

TEST(IniFields, SaysWhatWouldBeRight) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[things]\ncuont = 7\n",
       "a.ini:2: [things] cuont = 7: no such key; the nearest is \"count\""},
      {"[thing]\n", "a.ini:1: [thing]: no such section; the nearest is [things]"},
      {"[things]\nweight = 2\n",
       "a.ini:2: [things] weight = 2: no such key in this section: it belongs to [others]"},
      {"[things]\nshare = 0.5abc\n",
       "a.ini:2: [things] share = 0.5abc: is no number: it takes a number, 0 to 1"},
      {"[things]\nshare = 0,5\n", "a.ini:2: [things] share = 0,5: is no number"},
      {"[things]\nshare = 1.5\n",
       "a.ini:2: [things] share = 1.5: out of bounds: it takes a number, 0 to 1"},
      {"[things]\nanything = inf\n",
       "a.ini:2: [things] anything = inf: is no number: it takes a n"},
      {"[things]\nanything = nan\n", "a.ini:2: [things] anything = nan: is no number"},
      {"[things]\nanything = 1e999\n", "a.ini:2: [things] anything = 1e999: out of bounds"},
      {"[things]\nanything =\n", "a.ini:2: [things] anything = : is no number"},
      {"[things]\ncount = 2.5\n",
       "a.ini:2: [things] count = 2.5: is no whole number: it takes a whole number, 1 to 10"},
      {"[things]\ncount = 99999999999999999999\n", "a.ini:2: [things] count = 9999"},
      {"[things]\nseed = -1\n", "a.ini:2: [things] seed = -1: out of bounds"},
      {"[things]\nquick = maybe\n", "a.ini:2: [things] quick = maybe: it takes true or false"},
      {"[things]\ncolour = gren\n",
       "a.ini:2: [things] colour = gren: it takes one of red, green; the nearest is \"green\""}};
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(fieldComplaint(text).substr(0, expected.size()), expected);
}

TEST(IniFields, SettingsSayThatTheyAre) {
  Config config;
  setField(config, ariadne::io::parseSetting("things.count=4"));
  EXPECT_EQ(config.things.count, 4);
  try {
    setField(config, ariadne::io::parseSetting("things.count=40"));
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_EQ(std::string(e.what()).rfind("--set: [things] count = 40: out of bounds", 0), 0U);
  }
}

TEST(IniWriter, ReadsBackToTheSameBits) {
  for (std::uint32_t round = 0; round < 500; ++round) {
    ariadne::core::RandomStream random(9, round, 0, ariadne::core::Purpose::test);
    Config c;
    c.things.share = random.uniform();
    const std::uint64_t bits = (std::uint64_t(random.bits()) << 32) | random.bits();
    std::memcpy(&c.things.anything, &bits, sizeof(bits));
    if (!std::isfinite(c.things.anything)) c.things.anything = std::numeric_limits<double>::min();
    c.things.count = 1 + static_cast<int>(random.bits() % 10);
    c.things.seed = random.bits();
    c.things.quick = random.bits() % 2 != 0;
    for (int i = 0; i < 8; ++i) c.things.name += "ab ;#/\\=[]'\t "[random.bits() % 13];
    c.things.colour = random.bits() % 2 != 0 ? Colour::green : Colour::red;
    const Config back = readConfig(ariadne::io::writeIni(c, "header\nof two lines"));
    EXPECT_EQ(std::memcmp(&back.things.share, &c.things.share, 8), 0);
    EXPECT_EQ(std::memcmp(&back.things.anything, &c.things.anything, 8), 0);
    EXPECT_EQ(back.things.count, c.things.count);
    EXPECT_EQ(back.things.seed, c.things.seed);
    EXPECT_EQ(back.things.quick, c.things.quick);
    EXPECT_EQ(back.things.name, c.things.name);
    EXPECT_EQ(back.things.colour, c.things.colour);
  }
}

TEST(IniWriter, ExplainsEachKey) {
  const std::string text = ariadne::io::writeIni(Config(), "A run.");
  EXPECT_EQ(text.rfind("# A run.\n\n[things]\n# a share (a number, 0 to 1)\nshare = 0.5\n", 0), 0U)
      << text;
  EXPECT_NE(text.find("# a choice (one of red, green)\ncolour = red\n"), std::string::npos);
  const std::string page = ariadne::io::writeMarkdown(Config(), "# Page\n");
  EXPECT_NE(page.find("| `count` | `3` | a whole number, 1 to 10 | a count |"), std::string::npos);
}

TEST(IniWriter, RefusesWhatCannotBeReadBack) {
  for (const char* bad : {"two\nlines", "\"quote\" ; and comment"})
    EXPECT_THROW(ariadne::io::iniText(bad), UsageError) << bad;
  EXPECT_EQ(ariadne::io::iniText("plain path"), "plain path");
  EXPECT_EQ(ariadne::io::iniText("a #b"), "\"a #b\"");
}

TEST(IniWriter, AllParametersOfARunReadBack) {
  SlamParams params;
  params.filter.particles = 17;
  params.likelihood.hit_sigma_m = 0.1 + 0.2;
  const std::string text = ariadne::io::writeIni(params, "");
  SlamParams back;
  applyIni(back, ariadne::io::parseIni(text, "a.ini", IniDialect::strict));
  EXPECT_EQ(ariadne::io::writeIni(back, ""), text);
  EXPECT_EQ(back.likelihood.hit_sigma_m, 0.1 + 0.2);
}
