#include <gtest/gtest.h>

#include "../io/temporary_folder.h"
#include "ariadne/batch/config_differences.h"
#include "ariadne/batch/experiment_page.h"
#include "ariadne/io/whole_file.h"
#include "made_experiment.h"

using namespace ariadne;
using namespace ariadne::batch;

namespace {

class ExperimentPage : public TemporaryFolder {
 protected:
  /// The page of the experiment, in a folder with two INIs.
  std::string page() const {
    io::writeWhole(folder / "configs" / "c0.ini", std::string_view("[a]\nb = <1>\n"));
    io::writeWhole(folder / "configs" / "c1.ini", std::string_view("[a]\nb = 2\n"));
    const auto cells = m.cells();
    const auto plots = plotsOf(m.plan, cells);
    return experimentPage({m.plan, m.results, cells, plots, pictures}, Store(folder));
  }
  void SetUp() override {
    TemporaryFolder::SetUp();
    std::filesystem::create_directories(folder / "configs");
  }

  MadeExperiment m{{"1", "2"}};
  std::vector<Picture> pictures;
};

bool has(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

}  // namespace

TEST(ConfigDifferences, OfArmsOverAllTheirRuns) {
  MadeExperiment m({"1", "2"});
  m.plan.arms[1].program.path = "/bin/other";
  for (PlannedRun& run : m.plan.runs) run.config += run.values[0];
  const std::string tail = "\nsame = 1\n[run]\nthreads = ";
  const auto all = differencesOf(m.plan, {{"c01", "[a]\nlaps = 1\nb = x" + tail + "1\n"},
                                          {"c02", "[a]\nlaps = 2\nb = x" + tail + "2\n"},
                                          {"c11", "[a]\nlaps = 1\nb = 1" + tail + "3\n[c]\nd = 5"},
                                          {"c12", "[a]\nlaps = 2\nb = 2" + tail + "3\n"}});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].key, "program");
  EXPECT_EQ(all[0].values, (std::vector<std::string>{"", "other"}));
  EXPECT_EQ(all[1].key, "a.b");
  EXPECT_EQ(all[1].values, (std::vector<std::string>{"x", "1, 2"}));
  EXPECT_EQ(all[2].key, "c.d");
  EXPECT_EQ(all[2].values, (std::vector<std::string>{"", "5"}));
  EXPECT_EQ(differencesOf(m.plan, {{"c01", "no INI"}}).size(), 1U);
}

TEST_F(ExperimentPage, HasTablesDifferencesAndRuns) {
  m.plan.ini = "[experiment]\ntitle = T\n";
  m.results["3a1"].failure = "exit code 3";
  m.results["3a1"].last_words = "bad luck";
  m.results.erase("4a1");
  std::filesystem::create_directories(folder / "files" / "1b2");
  io::writeWhole(folder / "files" / "1b2" / "report.html", std::string_view("x"));
  const std::string text = page();
  for (const char* part :
       {"<dt>Finished</dt><dd>38</dd>", "<dt>Failed</dt><dd>1</dd>", "<dt>Missing</dt><dd>1</dd>",
        "<td>10/10 (100 %)</td>", "<td>a.b</td><td>&lt;1&gt;</td><td>2</td>",
        "<h3>seed 3, laps 1, one</h3>", "bad luck</pre>", "<td>missing</td>",
        "<a href=\"files/1b2/report.html\">report</a>", "title = T\n</pre>", "gnuplot was missing",
        "<td>one</td><td>5.5</td>"})
    EXPECT_TRUE(has(text, part)) << part;
  EXPECT_FALSE(has(text, "{{"));
  EXPECT_EQ(text, page());
}

TEST_F(ExperimentPage, NamesAreText) {
  const std::string nasty = "</pre><script>alert('\"')</script>{{runs}}&";
  m.plan.title = m.plan.arms[0].name = m.plan.factors[0] = m.plan.ini = nasty;
  for (PlannedRun& run : m.plan.runs)
    if (run.values[0] == "2") run.values[0] = nasty;
  m.results["3a1"].failure = m.results["3a1"].last_words = nasty;
  const std::string text = page();
  EXPECT_FALSE(has(text, "<script"));
  EXPECT_FALSE(has(text, "\"')"));
  EXPECT_TRUE(
      has(text, "&lt;/pre&gt;&lt;script&gt;alert(&#39;&quot;&#39;)&lt;/script&gt;{{runs}}&amp;"));
}

TEST_F(ExperimentPage, OfManyRunsIsUnderTenMegabytes) {
  m = MadeExperiment();
  m.plan.figures.assign(20, "x_m");
  for (std::uint64_t seed = 11; seed <= 15000; ++seed)
    for (std::size_t arm = 0; arm < 2; ++arm) {
      m.add(seed, {}, arm);
      if (seed > 14000) {
        auto& r = m.results[m.plan.runs.back().key];
        r.failure = "killed";
        r.last_words = std::string(4000, '<');
      }
    }
  const auto cells = m.cells();
  const std::vector<Plot> plots(1000);
  const std::vector<Picture> many(1000, {"x", "<svg" + std::string(20000, ' ') + "</svg>", ""});
  io::writeWhole(folder / "configs" / "c0.ini", std::string(900000, 'x'));
  io::writeWhole(folder / "configs" / "c1.ini", std::string(900000, 'y'));
  const std::string text = experimentPage({m.plan, m.results, cells, plots, many}, Store(folder));
  EXPECT_LT(text.size(), 10000000U);
  for (const char* what : {"more runs are left out", "more failed runs are left out",
                           "more plots are left out", "more INIs are left out"})
    EXPECT_TRUE(has(text, what)) << what;
}
