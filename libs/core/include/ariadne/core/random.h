// Counter-based random streams: a draw depends on (seed, step, particle, purpose) and on nothing
// else, so results are the same bits on any number of threads.
// Philox4x32-10: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011.
#pragma once
#include <array>
#include <cstdint>

namespace ariadne::core {

/// What a stream is drawn for; two purposes never share numbers.
enum class Purpose : std::uint32_t {
  motion = 1,
  proposal = 2,
  resampling = 3,
  noise = 4,
  range_noise = 5,
  recovery = 6,
  start = 7,
  bootstrap = 8,
  closure = 9,
  fork = 10,   ///< seeds of filters that were split off
  world = 11,  ///< a building
  test = 99
};

/// Random numbers that depend on a key and on nothing else: Random123's Philox, keyed by seed,
/// step, particle and purpose, so that threads and order do not matter (Salmon et al., SC 2011).
class RandomStream {
 public:
  /// The same four give the same numbers, on any machine.
  RandomStream(std::uint64_t seed, std::uint32_t step, std::uint32_t particle, Purpose purpose);

  /// The next 32 random bits.
  std::uint32_t bits();
  /// Uniform in the open interval (0, 1).
  double uniform();
  /// Standard normal (Box-Muller).
  double gaussian();

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::array<std::uint32_t, 4> block_{};
  int used_ = 4;
  bool has_spare_ = false;
  double spare_ = 0;
};

}  // namespace ariadne::core
