// Whether a laser looks all round, where its lines say no angle: then its first and its last beam
// are neighbours.
#pragma once
#include <cstddef>
#include <vector>

namespace ariadne::io {

class CarmenSeam {
 public:
  /// A scan, beam by beam.
  void add(const std::vector<float>& ranges_m);
  /// Whether the first and the last beam were as alike as neighbours are, from ten places at least.
  bool looksRound() const;

 private:
  float counted_m_ = 0;  ///< first beam of the last scan that was counted
  std::size_t scans_ = 0;
  std::size_t alike_ = 0;
  std::size_t pairs_ = 0;  ///< of neighbours
  std::size_t alike_pairs_ = 0;
};

}  // namespace ariadne::io
