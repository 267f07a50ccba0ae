// A reference-counted value that is copied when it is written to while somebody else holds it.
// Copying a Cow costs one increment; that is what makes copying a map, or keeping it as of a past
// step, cheap.
#pragma once
#include <atomic>
#include <cstddef>
#include <utility>

#include "ariadne/grid/tiles/tile_pool.h"

namespace ariadne::grid {

/// Shares one T between holders. Different holders may be used from different threads at once;
/// one holder may not. T must be copyable.
template <class T>
class Cow {
 public:
  Cow() = default;
  /// Shares the value: one atomic increment.
  Cow(const Cow& other) : node_(other.node_) {
    if (node_) node_->holders.fetch_add(1, std::memory_order_relaxed);
  }
  /// Takes the value over; `other` is empty then.
  Cow(Cow&& other) noexcept : node_(std::exchange(other.node_, nullptr)) {}
  /// By swap.
  Cow& operator=(Cow other) noexcept {
    std::swap(node_, other.node_);
    return *this;
  }
  ~Cow() {
    if (node_ && node_->holders.fetch_sub(1, std::memory_order_acq_rel) == 1) delete node_;
  }

  /// Null before the first write().
  const T* get() const { return node_ ? &node_->value : nullptr; }

  /// The value for writing: a new default one when empty, a copy of its own when shared.
  T& write() {
    if (!node_) {
      node_ = new Node;
    } else if (node_->holders.load(std::memory_order_acquire) != 1) {
      // Another thread may let go meanwhile; then the copy was not needed, and no harm is done.
      *this = Cow(new Node(node_->value));
    }
    return node_->value;
  }

  /// Holds a value of its own from here on; what was shared is not copied first.
  void assign(const T& value) {
    if (node_ && node_->holders.load(std::memory_order_acquire) == 1)
      node_->value = value;
    else
      *this = Cow(new Node(value));
  }

  /// True when both hold the very same value in memory.
  friend bool sameObject(const Cow& a, const Cow& b) { return a.node_ == b.node_; }

 private:
  struct Node {
    Node() = default;
    explicit Node(const T& v) : value(v) {}
    static void* operator new(std::size_t bytes) { return TilePool::take(bytes); }
    static void operator delete(void* memory, std::size_t bytes) { TilePool::give(memory, bytes); }
    alignas(16) T value{};  // rows are read sixteen cells at a time
    std::atomic<long> holders{1};
  };
  explicit Cow(Node* node) : node_(node) {}
  Node* node_ = nullptr;
};

}  // namespace ariadne::grid
