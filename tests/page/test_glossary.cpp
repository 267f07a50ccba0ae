// Words of pages, explained as the documents do.
#include <gtest/gtest.h>

#include "ariadne/page/glossary.h"

using namespace ariadne;

TEST(Glossary, IsThatOfTheDocuments) {
  EXPECT_EQ(page::meaningOf("te"),
            "the time (update) at which the robot was last at the entry point before the loop");
  EXPECT_EQ(page::meaningOf("frontier"), "a known free cell beside an unknown one (Yamauchi 1997)")
      << "links become their text";
  EXPECT_EQ(page::meaningOf("no such word"), "");
}

TEST(Glossary, ExplainsTheFirstWordThatItHas) {
  for (const char* text : {"ate_rmse_m", "rpe_m", "neff_share", "relations_m", "updates", "arm",
                           "survivors (%)", "recovered", "closings"})
    EXPECT_EQ(page::explained(text).find("<span class=\"term\" title=\""), 0U) << text;
  EXPECT_NE(page::explained("mean Neff / N").find("Eq. (10)"), std::string::npos);
  EXPECT_EQ(page::explained("late <b> \"latest\""), "late &lt;b&gt; &quot;latest&quot;");
  EXPECT_EQ(page::explained("charm"), "charm");
}
