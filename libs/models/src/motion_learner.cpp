#include "ariadne/models/motion_learner.h"

#include <algorithm>
#include <cmath>

#include "ariadne/models/motion_model.h"

namespace ariadne::models {
namespace {

using mrpt::math::TPose2D;

constexpr std::size_t kWindow = 200;
constexpr double kPriorSteps = 10;      // the given widths count as this many steps
constexpr double kBiasPriorSteps = 30;  // and a turn per metre of zero as this many
constexpr double kSafety = 1.5;         // odometry slips now and then, which a median does not see
constexpr double kNarrowest = 0.1;
constexpr double kLeastTravel_m = 0.05;
constexpr double kStraight_rad = 0.2;
constexpr double kLeastShare = 0.2;  // of the information across, for a direction to count

}  // namespace

void MotionLearner::Window::add(double value) {
  if (values_.size() < kWindow) {
    values_.push_back(value);
  } else {
    values_[next_] = value;
    next_ = (next_ + 1) % kWindow;
  }
}

double MotionLearner::Window::median() const {
  if (values_.empty()) return 0;
  std::vector<double> sorted = values_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

void MotionLearner::add(const TPose2D& increment, const TPose2D& matched, const TPose2D& before,
                        const Eigen::Matrix3d& information) {
  const double travel = std::hypot(increment.x, increment.y);
  if (travel < kLeastTravel_m || !(information(2, 2) > 0)) return;
  ++steps_;
  const double turn_off = std::remainder(matched.phi - increment.phi, 2 * M_PI);
  if (std::abs(increment.phi) < kStraight_rad) turn_per_m_.add(turn_off / travel);
  const Motion wide(increment, wide_);
  const double direction = std::atan2(increment.y, increment.x);
  const double c = std::cos(direction), s = std::sin(direction);
  const double dx = matched.x - increment.x, dy = matched.y - increment.y;
  const std::array<double, 3> off = {c * dx + s * dy, -s * dx + c * dy,
                                     turn_off - turnPerMetre() * travel};
  // Information about the position when the heading is not known, along and across the motion.
  const Eigen::Vector2d lever = information.topRightCorner<2, 1>();
  const Eigen::Rotation2Dd turn(-(before.phi + direction));
  const Eigen::Matrix2d position =
      turn.toRotationMatrix() *
      (information.topLeftCorner<2, 2>() - lever * lever.transpose() / information(2, 2)) *
      turn.toRotationMatrix().transpose();
  const double most = std::max(position(0, 0), position(1, 1));
  for (int i = 0; i < 2; ++i)
    if (most > 0 && position(i, i) >= kLeastShare * most)
      off_[static_cast<std::size_t>(i)].add(std::abs(off[static_cast<std::size_t>(i)]) /
                                            wide.sigma()[i]);
  off_[2].add(std::abs(off[2]) / wide.sigma()[2]);
}

std::array<double, 3> MotionLearner::scales() const {
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    // The median of |N(0, 1)| is 0.6745.
    const double spread = kSafety * off_[i].median() / 0.6745;
    const auto n = static_cast<double>(off_[i].size());
    out[i] = std::clamp(std::sqrt((n * spread * spread + kPriorSteps) / (n + kPriorSteps)),
                        kNarrowest, 1.0);
  }
  return out;
}

double MotionLearner::turnPerMetre() const {
  const auto n = static_cast<double>(turn_per_m_.size());
  return turn_per_m_.median() * n / (n + kBiasPriorSteps);
}

MotionParams MotionLearner::params() const {
  const auto [along, across, turn] = scales();
  MotionParams p = wide_;
  p.travel_per_m *= along;
  p.travel_per_turn_m *= std::max(along, across);
  p.side_per_m *= across;
  p.turn_per_turn *= turn;
  p.turn_per_m_deg *= turn;
  return p;
}

TPose2D MotionLearner::corrected(const TPose2D& increment) const {
  const double turn = turnPerMetre() * std::hypot(increment.x, increment.y);
  return {increment.x, increment.y, std::remainder(increment.phi + turn, 2 * M_PI)};
}

}  // namespace ariadne::models
