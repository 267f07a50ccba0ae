#include "ariadne/loops/search/finder.h"

#include <algorithm>
#include <cmath>

#include "ariadne/geometry/axes.h"
#include "ariadne/geometry/covariance.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/loops/search/piece.h"
#include "refine.h"

namespace ariadne::loops {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kCell_m = 0.2;
constexpr double kTurnStep_rad = 0.75 * M_PI / 180;
constexpr double kApart_m = 0.9;
constexpr double kReach_m = 6;  // the piece sees this far ahead of the robot well enough
constexpr double kHitRange_m = 25;
constexpr std::size_t kMostHits = 120;
constexpr std::size_t kMostPoints = 250;
constexpr std::size_t kFewestPoints = 60;
constexpr double kPieceGain =
    0.05;  // twenty points of the piece are worth one: they share their errors
constexpr double kSamePlace_m = 3;

bool moved(const TPose2D& a, const TPose2D& b) {
  return geometry::distance(a, b) > 0.02 ||
         std::abs(std::remainder(a.phi - b.phi, 2 * M_PI)) > 0.002;
}

double radiusOf(const std::vector<TPoint2D>& points) {
  double radius = 0;
  for (const TPoint2D& p : points) radius = std::max(radius, std::hypot(p.x, p.y));
  return radius;
}

/// Holds the robot in both directions.
bool isFirm(const Contact& c) {
  const Eigen::Matrix2d position = c.information.topLeftCorner<2, 2>();
  return geometry::axesOf(position).values[0] > 200;
}

}  // namespace

struct Finder::Sighting {
  Mode top;
  std::optional<Mode> second;
};

/// Places that a loop could close at.
struct Finder::Old {
  std::vector<bool> far;  // by update: far by the path and by contacts
  double half_m = 0;      // of the window; 0: none is within reach
  double half_turn_rad = 0;
  std::vector<Eigen::Matrix3d> drift;  // of now, given each update
};

Finder::Finder(const FinderParams& params, const grid::GridParams& grid,
               const grid::LikelihoodParams& likelihood)
    : params_(params), grid_(grid), likelihood_(likelihood, grid.field_sigma_m) {}

void Finder::add(const grid::Scan& scan, const Eigen::Matrix3d& motion_covariance) {
  hits_.push_back(grid::thinned(scan.hitsWithin(kHitRange_m), kMostHits));
  motion_covariance_.push_back(motion_covariance);
}

std::optional<Closure> Finder::look(const filter::AncestorPtr& best, const Scans& scans) {
  Track track = loops::trackOf(best, {});
  const double travelled = track.travelled_m.back();
  if (travelled < looked_m_ + params_.every_m && travelled > looked_m_ - 5) return std::nullopt;
  looked_m_ = travelled;
  track.motion_covariance = motion_covariance_;
  book_.extend(track, hits_);
  return search(track, scans);
}

Finder::Old Finder::oldPlaces(const Track& track) const {
  Old old;
  const std::size_t n = track.poses.size();
  old.far.assign(n, false);
  std::vector<Contact> firm;
  const std::vector<Contact> all = book_.all();
  std::copy_if(all.begin(), all.end(), std::back_inserter(firm), isFirm);
  const std::vector<double> by_contacts = distancesFromNow(track, firm);
  old.drift = driftSinceEach(track);
  const TPose2D& here = track.poses.back();
  for (std::size_t k = 0; k < n; ++k) {
    const double path_m = track.travelled_m.back() - track.travelled_m[k];
    if (path_m < params_.least_path_m || by_contacts[k] < params_.least_path_m) continue;
    old.far[k] = true;
    old.drift[k] *= std::min(1.0, by_contacts[k] / path_m);
    const double sigma_m =
        std::sqrt(geometry::axesOf(old.drift[k].topLeftCorner<2, 2>()).values[1]);
    const double half_m = std::min(params_.longest_window_m, 1 + 3 * sigma_m);
    if (geometry::distance(track.poses[k], here) > half_m + kReach_m) continue;
    old.half_m = std::max(old.half_m, half_m);
    old.half_turn_rad =
        std::max(old.half_turn_rad, std::min(0.5, 0.05 + 3 * std::sqrt(old.drift[k](2, 2))));
  }
  return old;
}

/// The scans that saw the place before, in a map of their own.
grid::OccupancyGrid Finder::mapAbout(const Track& track, const Scans& scans, const Old& old,
                                     const TPose2D& pose) const {
  constexpr std::size_t kMostScans = 60;
  constexpr double kNear_m = 15;
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < track.poses.size(); ++k)
    if (old.far[k] && geometry::distance(track.poses[k], pose) < kNear_m) near.push_back(k);
  const std::size_t stride = near.size() / kMostScans + 1;
  std::vector<grid::ScanShape> shapes;
  for (std::size_t i = 0; i < near.size(); i += stride)
    shapes.push_back(grid::makeScanShape(*scans[near[i]], grid_));
  std::vector<grid::PlacedScan> placed_scans;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    placed_scans.push_back({&shapes[i], track.poses[near[i * stride]]});
  grid::OccupancyGrid map(grid_);
  map.insertMany(placed_scans);
  return map;
}

/// Where the piece fits what was seen there before; nothing when no place stands out.
std::optional<Finder::Sighting> Finder::lookAround(const Track& track, const Old& old,
                                                   const std::vector<TPoint2D>& piece) const {
  const TPose2D& here = track.poses.back();
  const double half_m = old.half_m + radiusOf(piece) + 2 * kCell_m;
  HitRaster raster({here.x, here.y}, half_m, kCell_m);
  for (std::size_t k = 0; k < track.poses.size(); ++k)
    if (old.far[k] && geometry::distance(track.poses[k], here) < 1.5 * half_m + kHitRange_m)
      for (const TPoint2D& p : geometry::placed(track.poses[k], hits_[k])) raster.mark(p);
  const double share_here = static_cast<double>(raster.count(geometry::placed(here, piece))) /
                            static_cast<double>(piece.size());
  const auto modes =
      correlate(raster, piece, here, {old.half_m, old.half_turn_rad}, kTurnStep_rad, kApart_m, 2);
  if (modes.empty() || modes[0].at_edge || modes[0].hit_share < params_.least_hit_share)
    return std::nullopt;
  const double most = params_.most_second * modes[0].hit_share;
  if (share_here > most || (modes.size() > 1 && modes[1].hit_share > most)) return std::nullopt;
  Sighting sighting{modes[0], {}};
  if (modes.size() > 1) sighting.second = modes[1];
  return sighting;
}

/// The closure at a pose of the piece: anchored at the last visit of the place, since what was
/// before it stays as it is.
Closure Finder::closureAt(const Track& track, const Old& old, const grid::OccupancyGrid& map,
                          const std::vector<TPoint2D>& piece, const TPose2D& pose) const {
  Closure closure;
  double nearest = 1e9;
  for (std::size_t k = 0; k < track.poses.size(); ++k) {
    if (!old.far[k]) continue;
    const double d = geometry::distance(track.poses[k], pose);
    if (d < std::max(nearest, kSamePlace_m)) closure.anchor = k;
    nearest = std::min(nearest, d);
  }
  const TPose2D& anchor = track.poses[closure.anchor];
  closure.anchor_from_robot = geometry::relativePose(anchor, pose);
  closure.correction = geometry::relativePose(track.poses.back(), pose);
  const Eigen::Matrix3d known =
      kPieceGain * likelihood_.information(map, piece, pose) + 1e-3 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d turn = geometry::turnedBy(-anchor.phi);
  closure.information = (turn * known.inverse() * turn.transpose() + tieFloor()).inverse();
  std::vector<Tie> ties = tiesOf(track, book_.before(visitBegin(track, params_.least_path_m)));
  const SegmentSample without = drawSegment(track, 0, ties, nullptr);
  ties.push_back(
      {closure.anchor, track.now(), closure.anchor_from_robot, closure.information, false});
  const SegmentSample mean = drawSegment(track, 0, ties, nullptr);
  closure.cost = mean.cost;
  closure.begin = 0;
  while (closure.begin < closure.anchor &&
         !moved(without.poses[closure.begin], mean.poses[closure.begin]))
    ++closure.begin;
  return closure;
}

/// Whether the place was found where the last search had found it; remembers this one.
bool Finder::again(const TPose2D& here, const TPose2D& pose) {
  bool same = false;
  if (pending_) {
    const TPose2D expected = geometry::compose(*pending_, here);
    same = geometry::distance(expected, pose) < 0.75 &&
           std::abs(std::remainder(expected.phi - pose.phi, 2 * M_PI)) < 0.09;
  }
  pending_ = geometry::compose(pose, geometry::relativePose(here, {0, 0, 0}));  // map' from map
  return same;
}

std::optional<Closure> Finder::search(const Track& track, const Scans& scans) {
  const Old old = oldPlaces(track);
  if (old.half_m == 0) return std::nullopt;
  const std::vector<TPoint2D> piece =
      lastPiece(track, hits_, params_.piece_m, kCell_m, kMostPoints);
  if (piece.size() < kFewestPoints) return std::nullopt;
  const auto sighting = lookAround(track, old, piece);
  if (!sighting) {
    // One place that does not stand out for a moment is no sign against it.
    evidence_ = std::max(0.0, evidence_ - 0.5);
    return std::nullopt;
  }
  const grid::OccupancyGrid map = mapAbout(track, scans, old, sighting->top.map_from_piece);
  const Refined fine = refine(map, piece, sighting->top.map_from_piece);
  const double most_field = params_.most_second_field * fine.field;
  Closure closure = closureAt(track, old, map, piece, fine.map_from_piece);
  const bool agrees =
      fine.known_share >= params_.least_known && fine.field >= params_.least_field &&
      fine.contradicting <= params_.most_contradicting && closure.cost <= params_.most_cost &&
      refine(map, piece, track.poses.back()).field <= most_field &&
      (!sighting->second ||
       refine(map, piece, sighting->second->map_from_piece).field <= most_field);
  const bool sure = fine.field >= params_.sure_field && closure.cost <= params_.sure_cost &&
                    fine.contradicting <= params_.sure_contradicting;
  const bool same = again(track.poses.back(), fine.map_from_piece);
  evidence_ = !agrees ? 0 : (same ? evidence_ : 0) + (sure ? 1 : 0.5);
  if (evidence_ < params_.evidence) return std::nullopt;
  evidence_ = 0;
  pending_.reset();
  closure.hit_share = sighting->top.hit_share;
  closure.second_share = sighting->second ? sighting->second->hit_share : 0;
  keep(track, closure);
  return closure;
}

/// The last metres will lie over what they are tied to: whether their scans agree is seen anew.
void Finder::keep(const Track& track, const Closure& closure) {
  std::size_t anew = std::min(track.now() + 1, visitBegin(track, params_.least_path_m));
  while (anew > 0 && track.travelled_m.back() - track.travelled_m[anew - 1] < params_.piece_m)
    --anew;
  book_.close({closure.anchor, track.now(), closure.information, closure.anchor_from_robot}, anew);
}

}  // namespace ariadne::loops
