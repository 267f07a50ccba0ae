#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>
#include <thread>
#include <vector>

#include "ariadne/core/random.h"
#include "ariadne/grid/tiles/tile_pool.h"

using ariadne::core::RandomStream;
using ariadne::grid::TilePool;

namespace {

struct Taken {
  unsigned char* memory;
  std::size_t bytes;
  unsigned char mark;
};

/// Sizes as tiles have them, and some that are too large for the pool.
Taken takeMarked(RandomStream& rng) {
  const std::size_t bytes = 1 + rng.bits() % (rng.bits() % 10 == 0 ? 9000 : 1100);
  Taken t{static_cast<unsigned char*>(TilePool::take(bytes)), bytes,
          static_cast<unsigned char>(rng.bits())};
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(t.memory) % 16, 0U);
  std::memset(t.memory, t.mark, t.bytes);
  return t;
}

/// Nobody else wrote to it.
void giveChecked(const Taken& t) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < t.bytes; ++i) wrong += t.memory[i] != t.mark;
  EXPECT_EQ(wrong, 0U);
  TilePool::give(t.memory, t.bytes);
}

void takeAndGive(std::uint64_t seed, std::vector<Taken>& held) {
  RandomStream rng(seed, 0, 0, ariadne::core::Purpose::test);
  for (int i = 0; i < 20000; ++i) {
    if (held.empty() || rng.bits() % 2 == 0) {
      held.push_back(takeMarked(rng));
    } else {
      std::swap(held[rng.bits() % held.size()], held.back());
      giveChecked(held.back());
      held.pop_back();
    }
  }
}

}  // namespace

TEST(TilePool, EveryPieceHasOneOwner) {
  std::vector<Taken> held;
  takeAndGive(1, held);
  for (const Taken& t : held) giveChecked(t);
}

// Run under the tsan preset this is also a race detector.
TEST(TilePool, WhatOneThreadTookAnotherMayGive) {
  std::vector<std::vector<Taken>> held(4);
  for (std::uint64_t round = 0; round < 3; ++round) {
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < held.size(); ++i)
      threads.emplace_back([&, i] { takeAndGive(10 * round + i, held[i]); });
    for (auto& t : threads) t.join();
    std::rotate(held.begin(), held.begin() + 1, held.end());
  }
  for (const auto& of_thread : held)
    for (const Taken& t : of_thread) giveChecked(t);
}

#if !defined(__SANITIZE_ADDRESS__)
// Else a filter whose main thread lets go what its workers made would grow for ever.
TEST(TilePool, MemoryComesBackFromOtherThreads) {
  std::set<void*> places;
  for (int round = 0; round < 50; ++round) {
    std::vector<void*> taken(1000);
    std::thread([&] {
      for (void*& memory : taken) memory = TilePool::take(528);
    }).join();
    for (void* memory : taken) {
      places.insert(memory);
      TilePool::give(memory, 528);
    }
  }
  // What is in use at a time, and the batches that threads hold back.
  EXPECT_LE(places.size(), 1000U + 3 * 64);
}

namespace {

/// Holds a piece for longer than its thread has piles, as a static tile does in the main thread.
struct HeldToTheEnd {
  void* memory = nullptr;
  static constexpr std::size_t kBytes = 4000;  // a size that no other test has
  ~HeldToTheEnd() {
    if (memory) TilePool::give(memory, kBytes);
  }
};
thread_local HeldToTheEnd held_to_the_end;

}  // namespace

TEST(TilePool, WhatIsGivenBackLastOfAllIsNotLost) {
  void* last = nullptr;
  std::thread([&] {
    HeldToTheEnd& held = held_to_the_end;  // made before the thread's piles, so destroyed after
    last = held.memory = TilePool::take(HeldToTheEnd::kBytes);
  }).join();
  std::set<void*> places;
  std::vector<void*> taken(64);
  for (void*& memory : taken) places.insert(memory = TilePool::take(HeldToTheEnd::kBytes));
  for (void* memory : taken) TilePool::give(memory, HeldToTheEnd::kBytes);
  EXPECT_EQ(places.count(last), 1U);
}
#endif
