#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "ariadne/grid/tiles/cow.h"

using ariadne::grid::Cow;

namespace {

struct Counted {
  static inline std::atomic<int> alive{0};
  Counted() { ++alive; }
  Counted(const Counted& other) : value(other.value) { ++alive; }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --alive; }
  int value = 0;
};

}  // namespace

TEST(Cow, EmptyUntilWritten) {
  Cow<int> a;
  EXPECT_EQ(a.get(), nullptr);
  a.write() = 3;
  EXPECT_EQ(*a.get(), 3);
}

TEST(Cow, AWriteLeavesTheOtherHolderAsItWas) {
  Cow<int> a;
  a.write() = 1;
  Cow<int> b = a;
  EXPECT_TRUE(sameObject(a, b));
  b.write() = 2;
  EXPECT_EQ(*a.get(), 1);
  EXPECT_EQ(*b.get(), 2);
}

TEST(Cow, AssigningLeavesTheOtherHolderAsItWas) {
  Cow<Counted> a;
  a.assign({});
  const Counted* before = a.get();
  a.assign({});
  EXPECT_EQ(a.get(), before);
  const Cow<Counted> b = a;
  Counted seven;
  seven.value = 7;
  a.assign(seven);
  EXPECT_EQ(a.get()->value, 7);
  EXPECT_EQ(b.get()->value, 0);
}

TEST(Cow, ASoleHolderIsNotCopied) {
  Cow<Counted> a;
  a.write();
  { const Cow<Counted> b = a; }
  const Counted* before = a.get();
  a.write().value = 7;
  EXPECT_EQ(a.get(), before);
}

TEST(Cow, FreedWithItsLastHolder) {
  {
    Cow<Counted> a;
    a.write();
    std::vector<Cow<Counted>> holders(100, a);
    EXPECT_EQ(Counted::alive, 1);
    holders[3].write();
    EXPECT_EQ(Counted::alive, 2);
    a = {};
    holders.clear();
    EXPECT_EQ(Counted::alive, 0);
  }
  EXPECT_EQ(Counted::alive, 0);
}

// Run under the tsan preset this is also a race detector.
TEST(Cow, HoldersWriteFromManyThreads) {
  for (int round = 0; round < 50; ++round) {
    Cow<Counted> first;
    first.write().value = 1;
    std::vector<Cow<Counted>> holders(8, first);
    first = {};
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&holders, i] { holders[i].write().value += i; });
    for (auto& t : threads) t.join();
    for (int i = 0; i < 8; ++i) EXPECT_EQ(holders[i].get()->value, 1 + i);
  }
  EXPECT_EQ(Counted::alive, 0);
}
