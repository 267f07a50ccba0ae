// The MRPT classes that a mapper needs out of a rawlog, all versions up to those of
// rawlog_versions.h.
#pragma once
#include "ariadne/io/dataset_records.h"
#include "rawlog_archive.h"

namespace ariadne::io {

/// Each reads an object's content after its header, end flag included; throws ArchiveDamage.
LaserRecord readScan(ArchiveReader& in, const ObjectHeader& object);
OdometryReading readOdometry(ArchiveReader& in, const ObjectHeader& object);

struct Movement {
  OdometryIncrement increment;  ///< the raw increment of odometry, else the mean of the density
  bool from_matching = false;   ///< by scan matching, which MRPT prefers
};
Movement readMovement(ArchiveReader& in, const ObjectHeader& object);

/// UNIX seconds of MRPT's count of 100 ns since 1601; nullopt for 0, MRPT's "no stamp", and for
/// what is thousands of years away.
std::optional<double> secondsOfTicks(std::int64_t ticks);
/// The other way, exact to the tick.
mrpt::Clock::time_point clockOfSeconds(double time_s);

}  // namespace ariadne::io
