// Looks for the place at which a loop should close, from metres away: the last metres of scans as
// one piece against what was seen there before, over the window that the drift since then asks for.
// A place is told only when it stands out, contradicts nothing, and was found again some metres
// later.
#pragma once
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/grid/insertion/scan.h"
#include "ariadne/grid/params.h"
#include "ariadne/loops/search/contact_book.h"
#include "ariadne/loops/search/correlation.h"
#include "ariadne/loops/search/segment.h"

namespace ariadne::loops {

/// How often and how closely closures are searched for from metres away.
struct FinderParams {
  double every_m = 2;            ///< a search each time the robot has travelled this
  double least_path_m = 25;      ///< places nearer than this by the path are no closures
  double piece_m = 10;           ///< length of the piece
  double longest_window_m = 10;  ///< half width of the window at the most
  double least_hit_share = 0.55;
  double most_second = 0.8;  ///< the second-best place has at most this share of the best
  double least_known = 0.6;  ///< of the piece lies where the old map is known
  double least_field = 0.42;
  double most_second_field = 0.85;
  double most_contradicting = 0.33;
  double most_cost = 30;  ///< of the path given the closure, see SegmentSample
  /// A search that finds the place again counts 1 when it is sure in all of these, else one half.
  double sure_field = 0.5;
  double sure_contradicting = 0.15;
  double sure_cost = 12;
  double evidence = 2;  ///< counts, one search after the other
};

/// Where the robot is now, seen from a place of before.
struct Closure {
  std::size_t anchor = 0;  ///< update at the place
  std::size_t begin = 0;   ///< what was before this update need not be moved
  mrpt::math::TPose2D anchor_from_robot;
  Eigen::Matrix3d information;  ///< (x, y, heading) in the anchor's frame
  double hit_share = 0;
  double second_share = 0;
  double cost = 0;                 ///< of the path of s* given the closure, see SegmentSample
  mrpt::math::TPose2D correction;  ///< from where the robot was thought to be, in its own frame
};

/// Searches for places that the robot is at again although its map does not say so: the last piece
/// of the path is laid over everything that was seen before.
class Finder {
 public:
  /// One scan per update; shared with who keeps them.
  using Scans = std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>;

  /// @param grid which beams count, and the cells' size; @param likelihood how well a beam fits
  Finder(const FinderParams& params, const grid::GridParams& grid,
         const grid::LikelihoodParams& likelihood);

  /// Takes an update: its scan, and the covariance of its motion (see Track).
  void add(const grid::Scan& scan, const Eigen::Matrix3d& motion_covariance);
  /// To be called after each add() with the path of s*. Returns a closure that was found and
  /// confirmed.
  /// @param scans of all updates so far
  std::optional<Closure> look(const filter::AncestorPtr& best, const Scans& scans);
  /// The line of `leaf`, any particle's.
  Track trackOf(const filter::AncestorPtr& leaf) const {
    return loops::trackOf(leaf, motion_covariance_);
  }
  /// Where the path closed by itself, and what was found.
  std::vector<Contact> contacts() const { return book_.all(); }

 private:
  struct Old;
  struct Sighting;
  Old oldPlaces(const Track& track) const;
  std::optional<Closure> search(const Track& track, const Scans& scans);
  std::optional<Sighting> lookAround(const Track& track, const Old& old,
                                     const std::vector<mrpt::math::TPoint2D>& piece) const;
  Closure closureAt(const Track& track, const Old& old, const grid::OccupancyGrid& map,
                    const std::vector<mrpt::math::TPoint2D>& piece,
                    const mrpt::math::TPose2D& pose) const;
  bool again(const mrpt::math::TPose2D& here, const mrpt::math::TPose2D& pose);
  void keep(const Track& track, const Closure& closure);
  grid::OccupancyGrid mapAbout(const Track& track, const Scans& scans, const Old& old,
                               const mrpt::math::TPose2D& pose) const;

  FinderParams params_;
  grid::GridParams grid_;
  grid::EndpointLikelihood likelihood_;
  std::vector<ScanHits> hits_;  // by update, as the next
  std::vector<Eigen::Matrix3d> motion_covariance_;
  ContactBook book_;
  double looked_m_ = 0;
  std::optional<mrpt::math::TPose2D> pending_;  // correction in the map's frame
  double evidence_ = 0;
};

}  // namespace ariadne::loops
