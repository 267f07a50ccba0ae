// The frames of a recording and what is fixed among them, from /tf_static and from transforms on
// /tf that never change (ROS 1's static_transform_publisher repeats them there).
#pragma once
#include <mrpt/poses/CPose3D.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "messages.h"

namespace ariadne::io::ros {

mrpt::poses::CPose3D poseOf(const Pose& pose);

/// A transform parent_from_child as it was met in the recording.
struct Edge {
  mrpt::poses::CPose3D parent_from_child;  ///< the first one
  bool moves = false;                      ///< by over 1 mm or 0.1 degrees from it
  bool is_static = true;                   ///< never met but on /tf_static
  std::size_t count = 0;
};

class Frames {
 public:
  using Key = std::pair<std::string, std::string>;  ///< parent, child

  /// Takes a transform in; returns its edge. Throws BagDamage when there are over 100,000 edges.
  const Edge& add(const Transform& transform, bool is_static);
  const std::map<Key, Edge>& edges() const { return edges_; }

  /// The frames that are tied to this one by transforms that do not move, or by any; itself too.
  std::set<std::string> tiedTo(const std::string& frame, bool moving_too) const;
  /// target_from_source along transforms that do not move. When there is none, nullopt.
  std::optional<mrpt::poses::CPose3D> fixed(const std::string& target,
                                            const std::string& source) const;
  /// Names of the transforms on the chain from target to source, moving ones as well, as
  /// "a -> b (moves)"; empty where there is no chain.
  std::string chain(const std::string& target, const std::string& source) const;

 private:
  struct Step {
    std::string from;  ///< the frame before on the chain from the target
    const Edge* edge = nullptr;
    bool down = true;  ///< from parent to child
  };
  std::map<std::string, Step> reach(const std::string& target, bool moving_too) const;

  std::map<Key, Edge> edges_;
};

}  // namespace ariadne::io::ros
