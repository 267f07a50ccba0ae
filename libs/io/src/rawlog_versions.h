// The serialization versions of MRPT's classes that are decoded here: all up to these.
#pragma once
#include <array>
#include <string_view>

namespace ariadne::io {

struct KnownClass {
  std::string_view name;  ///< without namespace
  int newest;
};

/// Read off the sources of MRPT 2.5.8 and, where it writes newer ones, MRPT 3; a test compares with
/// what the installed MRPT writes.
constexpr std::array<KnownClass, 17> kKnownClasses = {{
    {"CObservation2DRangeScan", 8},  // 8 is MRPT 3's: how long a sweep takes
    {"CObservationOdometry", 2},
    {"CActionRobotMovement2D", 7},
    {"CActionCollection", 0},
    {"CSensoryFrame", 2},
    {"CPose2D", 1},
    {"CPose3D", 3},
    {"CPosePDFGaussian", 2},
    {"CPosePDFGaussianInf", 0},
    {"CPosePDFParticles", 1},
    {"CPosePDFSOG", 2},
    {"CMatrixF", 0},
    {"CMatrixD", 0},
    {"CSimpleMap", 2},  // 2 is MRPT 2.12's: velocities
    {"CPose3DPDFGaussian", 1},
    {"CPose3DPDFGaussianInf", 0},
    {"CPose3DPDFParticles", 1},
}};

/// -1 for a class that is not decoded here.
constexpr int newestKnown(std::string_view name) {
  for (const KnownClass& known : kKnownClasses)
    if (known.name == name) return known.newest;
  return -1;
}

}  // namespace ariadne::io
