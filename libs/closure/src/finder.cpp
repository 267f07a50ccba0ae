#include "ariadne/closure/finder.h"

#include <algorithm>
#include <cmath>

#include "ariadne/closure/piece.h"
#include "ariadne/models/motion_model.h"
#include "refine.h"

namespace ariadne::closure {
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
constexpr double kPieceGain = 0.05;

bool moved(const TPose2D& a, const TPose2D& b) {
  return distance(a, b) > 0.02 || std::abs(std::remainder(a.phi - b.phi, 2 * M_PI)) > 0.002;
}

double radiusOf(const std::vector<TPoint2D>& points) {
  double radius = 0;
  for (const TPoint2D& p : points) radius = std::max(radius, std::hypot(p.x, p.y));
  return radius;
}

/// Holds the robot in both directions.
bool isFirm(const Contact& c) {
  const Eigen::Matrix2d position = c.information.topLeftCorner<2, 2>();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(position).eigenvalues()[0] > 200;
}

}  // namespace

/// Places that a loop could close at.
struct Finder::Old {
  std::vector<bool> far;  // by update: far by the path and by contacts
  double half_m = 0;      // of the window; 0: none is within reach
  double half_turn_rad = 0;
  std::vector<Eigen::Matrix3d> drift;  // of now, given each update
};

Finder::Finder(const FinderParams& params, const DriftParams& drift, const grid::GridParams& grid,
               const grid::LikelihoodParams& likelihood)
    : params_(params), drift_(drift), grid_(grid), likelihood_(likelihood, grid.field_sigma_m) {}

void Finder::takeScans(const Scans& scans) {
  for (std::size_t k = hits_.size(); k < scans.size(); ++k)
    hits_.push_back(grid::thinned(
        grid::scanPoints(*scans[k], std::min(kHitRange_m, grid_.insert_range_m)), kMostHits));
}

std::optional<Closure> Finder::look(const filter::AncestorPtr& best, const Scans& scans) {
  takeScans(scans);
  const Track track = trackOf(best);
  const double travelled = track.travelled_m.back();
  if (travelled < looked_m_ + params_.every_m && travelled > looked_m_ - 5) return std::nullopt;
  looked_m_ = travelled;
  for (; contacts_until_ <= track.now(); ++contacts_until_)
    for (const Contact& c : findContacts(track, hits_, contacts_until_, contact_))
      contacts_.push_back(c);
  return search(track, scans);
}

std::vector<Contact> Finder::contacts() const {
  std::vector<Contact> all = contacts_;
  all.insert(all.end(), found_.begin(), found_.end());
  return all;
}

Finder::Old Finder::oldPlaces(const Track& track) const {
  Old old;
  const std::size_t n = track.poses.size();
  old.far.assign(n, false);
  std::vector<Contact> firm;
  const std::vector<Contact> all = contacts();
  std::copy_if(all.begin(), all.end(), std::back_inserter(firm), isFirm);
  const std::vector<double> by_contacts = distancesFromNow(track, firm);
  old.drift = driftSinceEach(track, drift_);
  const TPose2D& here = track.poses.back();
  for (std::size_t k = 0; k < n; ++k) {
    const double way = track.travelled_m.back() - track.travelled_m[k];
    if (way < params_.least_way_m || by_contacts[k] < params_.least_way_m) continue;
    old.far[k] = true;
    old.drift[k] *= std::min(1.0, by_contacts[k] / way);
    const double sigma_m =
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(old.drift[k].topLeftCorner<2, 2>())
                      .eigenvalues()[1]);
    const double half_m = std::min(params_.longest_window_m, 1 + 3 * sigma_m);
    if (distance(track.poses[k], here) > half_m + kReach_m) continue;
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
    if (old.far[k] && distance(track.poses[k], pose) < kNear_m) near.push_back(k);
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

std::optional<Closure> Finder::search(const Track& track, const Scans& scans) {
  const Old old = oldPlaces(track);
  if (old.half_m == 0) return std::nullopt;
  const TPose2D& here = track.poses.back();
  const std::vector<TPoint2D> piece =
      lastPiece(track, hits_, params_.piece_m, kCell_m, kMostPoints);
  if (piece.size() < 60) return std::nullopt;
  const double half_m = old.half_m + radiusOf(piece) + 2 * kCell_m;
  HitRaster raster({here.x, here.y}, half_m, kCell_m);
  for (std::size_t k = 0; k < track.poses.size(); ++k)
    if (old.far[k] && distance(track.poses[k], here) < 1.5 * half_m + kHitRange_m)
      for (const TPoint2D& p : placed(track.poses[k], hits_[k])) raster.mark(p);
  const double share_here =
      static_cast<double>(raster.count(placed(here, piece))) / static_cast<double>(piece.size());
  const auto modes =
      correlate(raster, piece, here, {old.half_m, old.half_turn_rad}, kTurnStep_rad, kApart_m, 2);
  if (modes.empty()) return std::nullopt;
  const Mode& top = modes[0];
  const double second = modes.size() > 1 ? modes[1].hit_share : 0;
  const bool stands_out = !top.at_edge && top.hit_share >= params_.least_hit_share &&
                          second <= params_.most_second * top.hit_share &&
                          share_here <= params_.most_second * top.hit_share;
  if (!stands_out) {
    evidence_ = std::max(0.0, evidence_ - 0.5);
    return std::nullopt;
  }
  const grid::OccupancyGrid map = mapAbout(track, scans, old, top.map_from_piece);
  const Refined fine = refine(map, piece, top.map_from_piece);
  Closure closure;
  closure.hit_share = top.hit_share;
  closure.second_share = second;
  // The last visit of the place: what was before it stays as it is.
  double nearest = 1e9;
  for (std::size_t k = 0; k < track.poses.size(); ++k) {
    if (!old.far[k]) continue;
    const double d = distance(track.poses[k], fine.map_from_piece);
    if (d < std::max(nearest, 3.0)) closure.anchor = k;
    nearest = std::min(nearest, d);
  }
  const TPose2D& anchor = track.poses[closure.anchor];
  closure.anchor_from_robot = models::relativePose(anchor, fine.map_from_piece);
  closure.correction = models::relativePose(here, fine.map_from_piece);
  const Eigen::Matrix3d floor = Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 8e-5).asDiagonal();
  const Eigen::Matrix3d known =
      kPieceGain * likelihood_.information(map, piece, fine.map_from_piece) +
      1e-3 * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(-anchor.phi).toRotationMatrix();
  closure.information = (turn * known.inverse() * turn.transpose() + floor).inverse();
  std::vector<Tie> ties = tiesOf(track, contacts());
  ties.push_back(
      {closure.anchor, track.now(), closure.anchor_from_robot, closure.information, false});
  const SegmentSample mean = drawSegment(track, 0, ties, drift_, nullptr);
  closure.begin = closure.anchor;
  for (std::size_t k = 0; k < closure.anchor; ++k)
    if (moved(track.poses[k + 1], mean.poses[k])) {
      closure.begin = k;
      break;
    }
  const double field_here = refine(map, piece, here).field;
  const double field_second =
      modes.size() > 1 ? refine(map, piece, modes[1].map_from_piece).field : 0;
  const bool agrees =
      fine.known_share >= params_.least_known && fine.field >= params_.least_field &&
      field_here <= params_.most_second_field * fine.field &&
      field_second <= params_.most_second_field * fine.field &&
      fine.contradicting <= params_.most_contradicting && mean.cost <= params_.most_cost;
  const TPose2D correction =
      models::compose(fine.map_from_piece, models::relativePose(here, {0, 0, 0}));  // map' from map
  bool again = false;
  if (pending_) {
    const TPose2D expected = models::compose(*pending_, here);
    again = distance(expected, fine.map_from_piece) < 0.75 &&
            std::abs(std::remainder(expected.phi - fine.map_from_piece.phi, 2 * M_PI)) < 0.09;
  }
  const bool sure = fine.field >= params_.sure_field && mean.cost <= params_.sure_cost &&
                    fine.contradicting <= params_.sure_contradicting;
  const double counts = sure ? 1 : 0.5;
  evidence_ = !agrees ? 0 : again ? evidence_ + counts : counts;
  pending_ = correction;
  closure.cost = mean.cost;
  if (evidence_ < params_.evidence) return std::nullopt;
  evidence_ = 0;
  pending_.reset();
  found_.push_back({closure.anchor, track.now(), closure.information});
  // The last metres will lie over what they are tied to: whether their scans agree is seen anew.
  while (contacts_until_ > 0 &&
         track.travelled_m.back() - track.travelled_m[contacts_until_ - 1] < params_.piece_m)
    --contacts_until_;
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const Contact& c) { return c.second >= contacts_until_; }),
                  contacts_.end());
  return closure;
}

}  // namespace ariadne::closure
