#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/whole_file.h"
#include "carmen_fan.h"
#include "output_file.h"

namespace ariadne::io {
namespace {

using mrpt::math::TPose2D;

constexpr const char* kHeader =
    "# CARMEN Logfile\n"
    "# file format is one message per line\n"
    "# message formats defined: ODOM ROBOTLASER1 FLASER\n"
    "# ODOM x y theta tv rv accel ipc_timestamp ipc_hostname logger_timestamp\n"
    "# ROBOTLASER1 laser_type start_angle field_of_view angular_resolution maximum_range accuracy "
    "remission_mode num_readings [range_readings] num_remissions [remission values] laser_pose_x "
    "laser_pose_y laser_pose_theta robot_pose_x robot_pose_y robot_pose_theta laser_tv laser_rv "
    "forward_safety_dist side_safety_dist turn_axis ipc_timestamp ipc_hostname logger_timestamp\n"
    "# FLASER num_readings [range_readings] x y theta odom_x odom_y odom_theta ipc_timestamp "
    "ipc_hostname logger_timestamp\n";
constexpr float kFlaserReach_m = 80;
constexpr const char* kFlaserNothing = "81.91";

/// A scan as CARMEN sees it: on the floor, counterclockwise.
struct FlatScan {
  TPose2D robot_from_laser;  ///< its axis is the middle beam
  double span_rad = 0;
  std::vector<std::size_t> order;  ///< index of each beam
};

FlatScan flatten(const mrpt::obs::CObservation2DRangeScan& scan) {
  FlatScan flat;
  const auto& rotation = scan.sensorPose.getRotationMatrix();
  flat.robot_from_laser = {scan.sensorPose.x(), scan.sensorPose.y(),
                           std::atan2(rotation(1, 0), rotation(0, 0))};
  flat.span_rad = scan.aperture;
  flat.order.resize(scan.getScanSize());
  for (std::size_t i = 0; i < flat.order.size(); ++i) flat.order[i] = i;
  const bool upside_down = rotation(2, 2) < 0;
  if (scan.rightToLeft == upside_down) std::reverse(flat.order.begin(), flat.order.end());
  return flat;
}

std::string poseText(const TPose2D& p) {
  return fmt::format("{:.9f} {:.9f} {:.9f}", p.x, p.y, std::remainder(p.phi, 2 * M_PI));
}

void appendRobotlaser(std::string& text, const models::SensorStep& step, const FlatScan& flat) {
  const auto& scan = *step.scan;
  const double steps = static_cast<double>(flat.order.size() - 1);
  auto out = std::back_inserter(text);
  fmt::format_to(out, "ROBOTLASER1 0 {:.9f} {:.9f} {:.12f} {} 0.01 0 {}", -flat.span_rad / 2,
                 flat.span_rad, flat.span_rad / steps, scan.maxRange, flat.order.size());
  for (const std::size_t i : flat.order) fmt::format_to(out, " {}", scan.getScanRange(i));
  fmt::format_to(out, " 0 {} {} 0 0 0 0 0", poseText(step.odom_from_robot + flat.robot_from_laser),
                 poseText(step.odom_from_robot));
}

void appendFlaser(std::string& text, const models::SensorStep& step, const FlatScan& flat,
                  const std::filesystem::path& path) {
  const auto& scan = *step.scan;
  const std::size_t count = flat.order.size();
  const CarmenFan fan = knownFan(count).value_or(CarmenFan());
  const double span = fan.step_rad * static_cast<double>(count - 1);
  if (std::abs(span - flat.span_rad) > 0.01)
    throw core::Error(
        fmt::format("cannot write {}: {} beams over {:.2f} degrees do not fit FLASER lines; "
                    "ROBOTLASER1 lines take them",
                    path.string(), count, flat.span_rad * 180 / M_PI));
  // The line's laser axis is not the middle beam where the left end is missing.
  TPose2D robot_from_laser = flat.robot_from_laser;
  robot_from_laser.phi -= fan.start_rad + span / 2;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "FLASER {}", count);
  for (const std::size_t i : flat.order) {
    const float range = scan.getScanRange(i);
    if (range < std::min(scan.maxRange, kFlaserReach_m)) {
      fmt::format_to(out, " {}", range);
    } else {
      fmt::format_to(out, " {}", kFlaserNothing);
    }
  }
  fmt::format_to(out, " {} {}", poseText(step.odom_from_robot + robot_from_laser),
                 poseText(step.odom_from_robot));
}

}  // namespace

std::size_t writeCarmen(const std::filesystem::path& path, const NextStep& next,
                        CarmenLaser laser) {
  std::size_t count = 0;
  writeWhole(path, [&](const std::filesystem::path& temporary) {
    OutputFile file(temporary, path, path.extension() == ".gz");
    file.write(kHeader);
    double begin_s = 0;
    while (const auto step = next()) {
      if (count++ == 0) begin_s = step->time_s;
      const std::string stamp =
          fmt::format(" {:.7f} ariadne {:.6f}\n", step->time_s, step->time_s - begin_s);
      std::string text = fmt::format("ODOM {} 0 0 0{}", poseText(step->odom_from_robot), stamp);
      const FlatScan flat = flatten(*step->scan);
      if (laser == CarmenLaser::robotlaser) appendRobotlaser(text, *step, flat);
      if (laser == CarmenLaser::flaser) appendFlaser(text, *step, flat, path);
      file.write(text += stamp);
    }
    file.close();
  });
  return count;
}

}  // namespace ariadne::io
