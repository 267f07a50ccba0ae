#include <gtest/gtest.h>

#include "ariadne/loops/places/shared_list.h"

using ariadne::loops::SharedList;

namespace {

std::vector<int> contents(const SharedList<int>& list) {
  std::vector<int> all;
  list.forEach([&](int v) { all.push_back(v); });
  return all;
}

SharedList<int> counted(int n) {
  SharedList<int> list;
  for (int i = 0; i < n; ++i) list.push_back(i);
  return list;
}

}  // namespace

TEST(SharedList, ReadsBackInOrderAcrossChunks) {
  const auto list = counted(200);
  ASSERT_EQ(list.size(), 200U);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(list[i], i);
  EXPECT_EQ(list.back(), 199);
  EXPECT_EQ(contents(list).size(), 200U);
}

TEST(SharedList, ChildrenGoTheirOwnWays) {
  const auto parent = counted(100);
  auto a = parent;
  auto b = parent;
  a.push_back(-1);
  b.push_back(-2);
  EXPECT_EQ(parent.size(), 100U);
  EXPECT_EQ(a.back(), -1);
  EXPECT_EQ(b.back(), -2);
  EXPECT_EQ(&a[10], &b[10]) << "the first chunk is still one";
  EXPECT_NE(&a[70], &b[70]);
}

TEST(SharedList, TruncatesToAnyLengthAndGrowsAgain) {
  for (const std::size_t to : {0U, 1U, 63U, 64U, 65U, 128U, 150U}) {
    auto list = counted(150);
    list.truncate(to);
    ASSERT_EQ(list.size(), to);
    list.push_back(7);
    EXPECT_EQ(list.back(), 7);
    for (std::size_t i = 0; i < to; ++i) EXPECT_EQ(list[i], static_cast<int>(i));
  }
}
