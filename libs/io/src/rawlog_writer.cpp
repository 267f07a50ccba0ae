#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include "ariadne/io/dataset_writers.h"
#include "ariadne/io/whole_file.h"
#include "output_file.h"

namespace ariadne::io {
namespace {

mrpt::obs::CActionCollection actionOf(const mrpt::math::TPose2D& motion,
                                      mrpt::system::TTimeStamp time) {
  mrpt::obs::CActionRobotMovement2D movement;
  movement.timestamp = time;
  movement.computeFromOdometry(mrpt::poses::CPose2D(motion), {});
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);
  return actions;
}

using Archive = mrpt::serialization::CArchive;

/// Writes what `put` makes of each step.
template <class Put>
std::size_t writeSteps(const std::filesystem::path& path, const NextStep& next, const Put& put) {
  std::size_t count = 0;
  writeWhole(path, [&](const std::filesystem::path& temporary) {
    OutputFile file(temporary, path, true);
    while (const auto step = next()) {
      mrpt::io::CMemoryStream memory;
      auto archive = mrpt::serialization::archiveFrom(memory);
      put(static_cast<Archive&>(archive), *step);
      file.write({static_cast<const char*>(memory.getRawBufferData()),
                  static_cast<std::size_t>(memory.getTotalBytesCount())});
      ++count;
    }
    file.close();
  });
  return count;
}

}  // namespace

std::size_t writeRawlog(const std::filesystem::path& path, const NextStep& next) {
  std::optional<mrpt::math::TPose2D> before;
  return writeSteps(path, next, [&](Archive& archive, const models::SensorStep& step) {
    const auto motion = before ? step.odom_from_robot - *before : mrpt::math::TPose2D();
    before = step.odom_from_robot;
    mrpt::obs::CSensoryFrame frame;
    frame.insert(step.scan);
    archive << actionOf(motion, step.scan->timestamp) << frame;
  });
}

std::size_t writeObservationRawlog(const std::filesystem::path& path, const NextStep& next) {
  return writeSteps(path, next, [](Archive& archive, const models::SensorStep& step) {
    mrpt::obs::CObservationOdometry reading;
    reading.timestamp = step.scan->timestamp;
    reading.sensorLabel = "odometry";
    reading.odometry = mrpt::poses::CPose2D(step.odom_from_robot);
    archive << reading << *step.scan;
  });
}

}  // namespace ariadne::io
