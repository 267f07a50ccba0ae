// Memory for tiles. Millions come and go while particles are copied and written to, and reading
// them is what a filter waits for: they lie in huge pages, since looking pages up was a third of a
// run, and side by side, without the 16 bytes that malloc adds to each.
#pragma once
#include <cstddef>

namespace ariadne::grid {

/// May be called from any thread; what one took another may give. Memory that is given back is
/// kept for tiles of the same size.
class TilePool {
 public:
  /// Aligned to 16 bytes. Throws std::bad_alloc.
  static void* take(std::size_t bytes);
  /// @param bytes as taken
  static void give(void* memory, std::size_t bytes) noexcept;
  /// Bytes that the pool has from the system.
  static std::size_t reserved();
};

}  // namespace ariadne::grid
