#include <gtest/gtest.h>

#include "ariadne/core/error.h"
#include "ariadne/io/csv.h"

using ariadne::io::CsvTable;

namespace {

std::string problemOf(const std::string& text) {
  try {
    const CsvTable table(text, "t.csv");
    for (std::size_t i = 0; i < table.size(); ++i) table.number(i, table.column("x"));
  } catch (const ariadne::core::Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Csv, ReadsWhatAWriterQuotes) {
  const CsvTable table("name,x\n\"a, b\",1\n\"said \"\"no\"\"\nand went\",2.5\nplain,-3e2\n",
                       "t.csv");
  ASSERT_EQ(table.size(), 3U);
  EXPECT_EQ(table.row(0)[0], "a, b");
  EXPECT_EQ(table.row(1)[0], "said \"no\"\nand went");
  EXPECT_EQ(table.number(1, table.column("x")), 2.5);
  EXPECT_EQ(table.number(2, 1), -300);
  EXPECT_EQ(table.place(2), "t.csv:5") << "lines within quotes count";
}

TEST(Csv, TakesLineEndsOfAnySystemAndNoneAtTheEnd) {
  for (const char* text : {"a,x\r\n1,2\r\n", "a,x\n1,2", "a,x\r\n1,2\r\n\r\n"}) {
    const CsvTable table(text, "t.csv");
    ASSERT_EQ(table.size(), 1U) << text;
    EXPECT_EQ(table.row(0), (std::vector<std::string>{"1", "2"}));
  }
  EXPECT_EQ(CsvTable("", "t.csv").size(), 0U);
  EXPECT_EQ(CsvTable("a,b\n,\n", "t.csv").row(0), (std::vector<std::string>{"", ""}));
}

TEST(Csv, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_EQ(problemOf("a,x\n1,2\n1\n2,3\n"), "t.csv:3: 1 cells; the header has 2");
  EXPECT_EQ(problemOf("a,x\n\"1,2\n"), "t.csv:3: a quote has no end");
  EXPECT_EQ(problemOf("a,x\n\"1\"2,2\n"),
            "t.csv:2: something stands behind a cell's closing quote");
  EXPECT_EQ(problemOf("a,y\n1,2\n"), "t.csv:1: there is no column x");
  EXPECT_EQ(problemOf("a,x\n1,2,5\n"), "t.csv:2: 3 cells; the header has 2");
  EXPECT_EQ(problemOf("a,x\n1,nan\n"), "t.csv:2: x: \"nan\" is no number");
  EXPECT_EQ(problemOf("a,x\n1,\n"), "t.csv:2: x: \"\" is no number");
}
