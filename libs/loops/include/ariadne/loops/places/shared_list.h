// A list that only grows at its end, in chunks that copies share until they write to them: the
// history of one hypothesis, of which its children keep the part they have in common.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "ariadne/grid/cow.h"

namespace ariadne::loops {

template <class T>
class SharedList {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return (*chunks_[i / kChunk].get())[i % kChunk]; }
  const T& back() const { return (*this)[size_ - 1]; }

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
