// Watches s* for loops while somebody drives the robot: when an opportunity opens, when the robot
// comes to its entry, when it leaves what it knew. Says when to save and when to recover; does
// neither.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ariadne/loops/closing/stop_rules.h"
#include "ariadne/loops/places/loop_opportunity.h"

namespace ariadne::loops {

/// Of the robot: on new ground or among known places, on the way to an entry point, or following a
/// loop behind it.
enum class LoopState { exploring, approaching, closing };

/// What the watcher sees of one filter update, all of s*.
struct WatchedStep {
  const PlaceGraph& graph;  ///< with this update's visit
  const grid::OccupancyGrid& map;
  ClosingStep figures;
};

/// A closing from its detection on.
struct Closing {
  std::size_t id = 0;  ///< counts from 0
  LoopOpportunity opportunity;
  mrpt::math::TPoint2D entry_position;  ///< m, map of s* at detection
  std::size_t detected = 0;             ///< filter update
  std::optional<std::size_t> entered;   ///< filter update at which the entry was reached
  std::optional<std::size_t> ended;     ///< filter update of the end
  std::string end_reason;               ///< empty while open
  std::optional<double>
      neff_rule_m;  ///< distance after the entry at which the paper's rule would stop
  std::optional<double> slope_rule_m;  ///< the same of the fallback
  double last_known_m = 0;  ///< travelled, when a place of the loop or before it was last visited
  ClosingCourse course;
};

/// What an update brought about; several may come together.
struct LoopEvents {
  std::optional<std::size_t> detected;  ///< save the set as of its te
  std::optional<std::size_t> entered;   ///< join the present place with the entry in every G
  std::vector<std::size_t> given_up;    ///< drop what was saved
  std::optional<std::size_t> ended;     ///< recover; what was saved later goes too
};

/// Detects loops, sees when they are entered and when their closing ends (Section IV of the paper).
class LoopWatcher {
 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  explicit LoopWatcher(const ClosingParams& params);

  /// To be called once per filter update, in order.
  LoopEvents observe(const WatchedStep& step);

  /// After the last update.
  LoopState state() const;
  /// Opportunity of the last update; none within the cooldown.
  const std::optional<LoopOpportunity>& opportunity() const { return opportunity_; }
  /// All closings so far, open ones too.
  const std::vector<Closing>& closings() const { return closings_; }
  /// The closing on top of the open ones.
  const Closing* open() const;
  /// All open ones, the outermost first; until the next observation.
  std::vector<const Closing*> allOpen() const;

 private:
  bool counts(const Place& place, const WatchedStep& step) const;
  void detect(const WatchedStep& step, LoopEvents& events);
  void approach(const WatchedStep& step, LoopEvents& events);
  void follow(const WatchedStep& step, LoopEvents& events);
  bool atEntry(const Closing& closing, const PlaceGraph& graph) const;
  std::string reasonToEnd(Closing& closing, const WatchedStep& step) const;
  void end(std::size_t id, const std::string& reason, std::size_t update);

  ClosingParams params_;
  StopRule rule_;
  std::vector<Closing> closings_;
  std::vector<std::size_t> open_;    // ids, oldest first; only the last may be approaching
  std::vector<double> travelled_m_;  // by filter update
  std::vector<double> uncertainty_m_;
  struct Interval {
    std::size_t first;
    std::size_t last;
  };
  std::vector<Interval> closed_;  // filter updates of loops that were closed
  std::optional<double> quiet_until_m_;
  std::optional<LoopOpportunity> opportunity_;
};

}  // namespace ariadne::loops
