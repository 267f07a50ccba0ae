#include <gtest/gtest.h>

#include "ariadne/core/fields.h"

namespace {

struct Params {
  double beta = 0.5;
  int count = 3;
};

template <class V>
void visitFields(V& v, Params& p) {
  v.number("beta", p.beta, {0, 1}, "a share");
  v.number("count", p.count, {1, 10}, "a count");
}

std::string complaint(const Params& p) {
  try {
    ariadne::core::validateFields(p, "filter");
  } catch (const ariadne::core::UsageError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(Fields, DefaultsAreValid) { EXPECT_EQ(complaint({}), ""); }

TEST(Fields, NamesSectionKeyValueAndBound) {
  const std::string text = complaint({1.5, 3});
  for (const char* part : {"[filter]", "beta", "1.5", "0 to 1"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(Fields, NanIsOutOfBounds) { EXPECT_NE(complaint({std::nan(""), 3}), ""); }
