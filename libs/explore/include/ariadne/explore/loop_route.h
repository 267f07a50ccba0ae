// The route through a loop once its entry is reached: along the path that was taken after te, in
// the order of time (section IV). It is known as steps of s*'s ancestry, not as coordinates, since
// s* may change meanwhile.
#pragma once
#include <optional>

#include "ariadne/filter/ancestry.h"

namespace ariadne::explore {

/// The route round a loop: along the path that s* took through it.
class LoopRoute {
 public:
  /// @param te filter update of the entry
  /// @param entered filter update at which the robot was back there: where the path ends
  LoopRoute(std::size_t te, std::size_t entered) : te_(te), entered_(entered), cursor_(te) {}

  /// The place on the path, a few metres ahead of the robot, to go to next.
  /// @param leaf of s*
  mrpt::math::TPoint2D next(const filter::AncestorPtr& leaf,
                            const mrpt::math::TPose2D& map_from_robot);
  /// Leaves out the part of the path up to the place that next() named last.
  void skip() { cursor_ = ahead_; }
  /// How often the path was driven from te to its end, the part of the present lap as well.
  double laps() const;

 private:
  std::size_t te_;
  std::size_t entered_;
  std::size_t cursor_;     // the update whose place the robot has come to
  std::size_t ahead_ = 0;  // the one named last
  int whole_laps_ = 0;
};

}  // namespace ariadne::explore
