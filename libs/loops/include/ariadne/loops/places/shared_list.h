// A list that only grows at its end, in chunks that copies share until they write to them: the
// history of one hypothesis, of which its children keep the part they have in common.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "ariadne/grid/tiles/cow.h"

namespace ariadne::loops {

/// A list that only grows; copies share all full chunks.
template <class T>
class SharedList {
 public:
  /// Number of items.
  std::size_t size() const { return size_; }
  /// Without items.
  bool empty() const { return size_ == 0; }
  /// i in [0, size()).
  const T& operator[](std::size_t i) const { return (*chunks_[i / kChunk].get())[i % kChunk]; }
  /// The last item; there must be one.
  const T& back() const { return (*this)[size_ - 1]; }

  /// Copies the last chunk where another list shares it.
  void push_back(const T& value) {
    if (size_ % kChunk == 0) chunks_.emplace_back();
    chunks_.back().write()[size_++ % kChunk] = value;
  }
  /// Forgets all but the first `size`.
  void truncate(std::size_t size) {
    if (size >= size_) return;
    size_ = size;
    chunks_.resize((size + kChunk - 1) / kChunk);
  }
  /// Calls f(value) in order.
  template <class F>
  void forEach(F&& f) const {
    for (std::size_t first = 0; first < size_; first += kChunk) {
      const auto& chunk = *chunks_[first / kChunk].get();
      for (std::size_t i = 0; i < kChunk && first + i < size_; ++i) f(chunk[i]);
    }
  }

 private:
  static constexpr std::size_t kChunk = 64;
  std::vector<grid::Cow<std::array<T, kChunk>>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace ariadne::loops
