// MRPT's poses and pose densities out of a rawlog, all versions up to those of rawlog_versions.h.
#pragma once
#include <mrpt/math/TPose2D.h>
#include <mrpt/poses/CPose3D.h>

#include "rawlog_archive.h"

namespace ariadne::io {

/// Each reads a whole object, header included; throws ArchiveDamage.
mrpt::poses::CPose3D readPose3D(ArchiveReader& in);
mrpt::math::TPose2D readPose2D(ArchiveReader& in);
/// Mean of a CPosePDF of any kind.
mrpt::math::TPose2D readDensity(ArchiveReader& in);
/// Mean of a CPose3DPDF, one Gaussian or particles, on the floor.
mrpt::math::TPose2D readDensity3D(ArchiveReader& in);
/// A matrix that old objects carry and nobody needs.
void passCovariance(ArchiveReader& in);

}  // namespace ariadne::io
