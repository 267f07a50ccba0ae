// Small logs for tests: rawlogs as MRPT itself writes them, CARMEN lines, and what a reader makes
// of a file.
#pragma once
#include <fmt/format.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "ariadne/core/error.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/whole_file.h"

namespace sample {

namespace io = ariadne::io;
using mrpt::math::TPose2D;

constexpr double kBegin_s = 1.5e9;

inline mrpt::obs::CObservation2DRangeScan::Ptr scan(double time_s, const std::string& label = "",
                                                    std::size_t beams = 19) {
  auto s = mrpt::obs::CObservation2DRangeScan::Create();
  s->timestamp = mrpt::Clock::fromDouble(time_s);
  s->sensorLabel = label;
  s->aperture = static_cast<float>(M_PI);
  s->maxRange = 30;
  s->sensorPose = mrpt::poses::CPose3D(0.2, 0, 0.3, 0, 0, 0);
  s->resizeScan(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    s->setScanRange(i, 1.0F + 0.25F * static_cast<float>(i));
    s->setScanRangeValidity(i, true);
  }
  return s;
}

inline mrpt::obs::CObservationOdometry odometry(double time_s, const TPose2D& pose) {
  mrpt::obs::CObservationOdometry o;
  o.timestamp = mrpt::Clock::fromDouble(time_s);
  o.odometry = mrpt::poses::CPose2D(pose);
  return o;
}

inline mrpt::obs::CActionCollection action(const TPose2D& motion) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.computeFromOdometry(mrpt::poses::CPose2D(motion), {});
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

/// An observation that a mapper has no use for.
inline mrpt::obs::CObservationIMU imu() {
  mrpt::obs::CObservationIMU o;
  o.sensorLabel = "an IMU";
  return o;
}

/// The bytes of a rawlog, not compressed.
class Rawlog {
 public:
  template <class Object>
  Rawlog& add(const Object& object) {
    archive_ << object;
    return *this;
  }
  Rawlog& frame(const std::vector<mrpt::obs::CObservation::Ptr>& observations) {
    mrpt::obs::CSensoryFrame f;
    for (const auto& o : observations) f.insert(o);
    return add(f);
  }
  std::string bytes() {
    return {static_cast<const char*>(memory_.getRawBufferData()),
            static_cast<std::size_t>(memory_.getTotalBytesCount())};
  }

 private:
  mrpt::io::CMemoryStream memory_;
  mrpt::serialization::CArchiveStreamBase<mrpt::io::CMemoryStream> archive_{memory_};
};

/// A drive of `steps` steps of 0.5 m ahead and 0.1 rad left, 0.2 s apart.
inline std::string pairsLog(int steps) {
  Rawlog log;
  for (int i = 0; i < steps; ++i)
    log.add(action(i == 0 ? TPose2D() : TPose2D(0.5, 0, 0.1))).frame({scan(kBegin_s + 0.2 * i)});
  return log.bytes();
}

inline std::string observationsLog(int steps) {
  Rawlog log;
  for (int i = 0; i <= steps; ++i) {
    log.add(odometry(kBegin_s + 0.2 * i, {0.5 * i, 0, 0}));
    if (i < steps) log.add(*scan(kBegin_s + 0.2 * i + 0.1));
  }
  return log.bytes();
}

inline std::string flaser(std::size_t beams, const std::string& range, const std::string& laser,
                          const std::string& robot, double time_s) {
  std::string line = fmt::format("FLASER {}", beams);
  for (std::size_t i = 0; i < beams; ++i) line += " " + range;
  return line + fmt::format(" {} {} {:.6f} host {:.6f}\n", laser, robot, time_s, time_s - kBegin_s);
}

inline std::string carmenLog(int steps) {
  std::string text = "# a comment\nPARAM robot_width 0.5 1.0 host 1.0\n";
  for (int i = 0; i < steps; ++i) {
    const std::string pose = fmt::format("{} 0 0.1", 0.5 * i);
    text += fmt::format("ODOM {} 0 0 0 1.0 host 1.0\n", pose);
    text += flaser(181, "2.5", pose, pose, kBegin_s + 0.2 * i);
  }
  return text;
}

struct Result {
  std::vector<ariadne::models::SensorStep> steps;
  io::DatasetCounts counts;
  std::vector<std::string> warnings;
  std::string label;
  std::string error;  ///< of core::Error; anything else is not caught
  bool warns(const std::string& part) const {
    for (const std::string& w : warnings)
      if (w.find(part) != w.npos) return true;
    return false;
  }
};

inline Result read(const std::filesystem::path& path, const io::DatasetOptions& options) {
  Result r;
  try {
    const auto source = io::openDataset(path, options);
    while (auto step = source->next()) r.steps.push_back(std::move(*step));
    r.counts = source->counts();
    r.warnings = source->warnings();
    r.label = source->laserLabel();
  } catch (const ariadne::core::Error& e) {
    r.error = e.what();
  }
  return r;
}

inline Result read(const std::filesystem::path& path, const std::string& label = "") {
  io::DatasetOptions options;
  options.laser_label = label;
  return read(path, options);
}

inline Result readBytes(const std::filesystem::path& path, const std::string& bytes,
                        const std::string& label = "") {
  io::writeWhole(path, bytes);
  return read(path, label);
}

/// A real log beside the project or under $ARIADNE_DATASETS; empty where it is missing.
inline std::filesystem::path realLog(const std::string& name) {
  const char* given = std::getenv("ARIADNE_DATASETS");
  const char* source = std::getenv("ARIADNE_SOURCE_DIR");
  const std::filesystem::path folder =
      given != nullptr
          ? std::filesystem::path(given)
          : std::filesystem::path(source != nullptr ? source : ".") / "../shared/datasets";
  return std::filesystem::exists(folder / name) ? folder / name : std::filesystem::path();
}

/// One of the small inputs of ../shared/cases, beside the datasets; empty where it is missing.
inline std::filesystem::path sharedCase(const std::string& name) {
  return realLog("../cases/" + name);
}

constexpr const char* kMrptSample =
    "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";

}  // namespace sample
