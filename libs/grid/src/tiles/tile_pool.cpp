#include "ariadne/grid/tiles/tile_pool.h"

#include <sys/mman.h>

#include <array>
#include <cstdlib>
#include <mutex>
#include <new>
#include <vector>

namespace ariadne::grid {
namespace {

constexpr std::size_t kStep = 16;       // sizes are multiples of it
constexpr std::size_t kMost = 4096;     // larger ones are malloc's
constexpr std::size_t kBatch = 32;      // how many change hands at a time
constexpr std::size_t kHuge = 2 << 20;  // a huge page

struct Piece {
  Piece* next;
};

/// Pieces of one size.
struct Pile {
  Piece* top = nullptr;
  std::size_t count = 0;
  void push(Piece* piece) {
    piece->next = top;
    top = piece;
    ++count;
  }
  Piece* pop() {
    Piece* piece = top;
    top = piece->next;
    --count;
    return piece;
  }
};

using Piles = std::array<Pile, kMost / kStep + 1>;

/// Where threads get batches from and bring them to.
class Store {
 public:
  /// It outlives every thread: never destroyed.
  static Store& instance() {
    static auto* const store = new Store;
    return *store;
  }

  void fill(Pile& pile, std::size_t size) {
    const std::lock_guard lock(mutex_);
    std::vector<Pile>& full = full_[size];
    if (!full.empty()) {
      pile = full.back();
      full.pop_back();
      return;
    }
    for (std::size_t i = 0; i < kBatch; ++i) pile.push(cut(size * kStep));
  }
  void keep(const Pile& pile, std::size_t size) {
    const std::lock_guard lock(mutex_);
    full_[size].push_back(pile);
  }
  std::size_t reserved() {
    const std::lock_guard lock(mutex_);
    return reserved_;
  }

 private:
  Piece* cut(std::size_t bytes) {
    if (left_ < bytes) {
      // Huge pages are wished for, not asked for: without them all works, slower.
      void* chunk = std::aligned_alloc(kHuge, kHuge);
      if (!chunk) throw std::bad_alloc();
      ::madvise(chunk, kHuge, MADV_HUGEPAGE);
      next_ = static_cast<std::byte*>(chunk);
      left_ = kHuge;
      reserved_ += kHuge;
    }
    auto* piece = reinterpret_cast<Piece*>(next_);
    next_ += bytes;
    left_ -= bytes;
    return piece;
  }

  std::mutex mutex_;
  std::array<std::vector<Pile>, kMost / kStep + 1> full_;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
  std::size_t reserved_ = 0;
};

// Statics and other thread-local objects may hold tiles for longer than the thread has piles.
thread_local bool piles_are_gone = false;

/// What a thread has at hand, two batches of a size at the most.
struct AtHand {
  Piles piles;
  ~AtHand() {
    piles_are_gone = true;
    for (std::size_t size = 0; size < piles.size(); ++size)
      if (piles[size].count > 0) Store::instance().keep(piles[size], size);
  }
};

/// Null once the thread is about to end.
Pile* atHand(std::size_t size) {
  if (piles_are_gone) return nullptr;
  static thread_local AtHand at_hand;
  return &at_hand.piles[size];
}

Piece* takeFromStore(std::size_t size) {
  Pile pile;
  Store::instance().fill(pile, size);
  Piece* piece = pile.pop();
  if (pile.count > 0) Store::instance().keep(pile, size);
  return piece;
}

void giveToStore(Piece* piece, std::size_t size) {
  Pile pile;
  pile.push(piece);
  Store::instance().keep(pile, size);
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kPooled = false;  // so that a tile that was let go is found out when it is used
#else
constexpr bool kPooled = true;
#endif

}  // namespace

void* TilePool::take(std::size_t bytes) {
  if (!kPooled || bytes > kMost) return ::operator new(bytes);
  const std::size_t size = (bytes + kStep - 1) / kStep;
  Pile* const pile = atHand(size);
  if (!pile) return takeFromStore(size);
  if (pile->count == 0) Store::instance().fill(*pile, size);
  return pile->pop();
}

void TilePool::give(void* memory, std::size_t bytes) noexcept {
  if (!kPooled || bytes > kMost) {
    ::operator delete(memory);
    return;
  }
  const std::size_t size = (bytes + kStep - 1) / kStep;
  Pile* const pile = atHand(size);
  if (!pile) return giveToStore(static_cast<Piece*>(memory), size);
  pile->push(static_cast<Piece*>(memory));
  if (pile->count < 2 * kBatch) return;
  Pile batch;
  for (std::size_t i = 0; i < kBatch; ++i) batch.push(pile->pop());
  Store::instance().keep(batch, size);
}

std::size_t TilePool::reserved() { return Store::instance().reserved(); }

}  // namespace ariadne::grid
