#include <gtest/gtest.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>
#include <mrpt/poses/CPose3DPDFParticles.h>
#include <mrpt/serialization/CArchive.h>

#include <iterator>

#include "ariadne/core/error.h"
#include "ariadne/io/map_files.h"
#include "ariadne/io/simplemap_file.h"
#include "ariadne/io/whole_file.h"
#include "temporary_folder.h"

namespace io = ariadne::io;
using mrpt::maps::CSimpleMap;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;

class SimplemapFile : public TemporaryFolder {
 protected:
  static CObservation2DRangeScan::Ptr scanOf(float range_m) {
    auto scan = CObservation2DRangeScan::Create();
    scan->aperture = 3;
    scan->maxRange = 20;
    scan->resizeScan(31);
    for (std::size_t k = 0; k < 31; ++k) {
      scan->setScanRange(k, range_m);
      scan->setScanRangeValidity(k, true);
    }
    return scan;
  }
  static mrpt::obs::CSensoryFrame::Ptr frameOf(const mrpt::obs::CObservation::Ptr& observation) {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(observation);
    return frame;
  }
  static CSimpleMap threeScans() {
    CSimpleMap map;
    for (int i = 0; i < 3; ++i)
      map.insert(mrpt::poses::CPose3DPDFGaussian::Create(CPose3D(i, 2, 0, 0.5 * i, 0, 0)),
                 frameOf(scanOf(static_cast<float>(i) + 1)));
    return map;
  }
  /// As MRPT writes it, unpacked.
  static std::string bytesOf(const CSimpleMap& map) {
    mrpt::io::CMemoryStream memory;
    mrpt::serialization::archiveFrom(memory) << map;
    return {static_cast<const char*>(memory.getRawBufferData()), memory.getTotalBytesCount()};
  }
  std::string errorOf(const std::string& bytes) {
    io::writeWhole(folder / "a.simplemap", bytes);
    try {
      io::readSimplemap(folder / "a.simplemap");
    } catch (const ariadne::core::Error& e) {
      return e.what();
    }
    return "";
  }
};

TEST_F(SimplemapFile, WhatWasWrittenIsRead) {
  io::writeSimplemap(folder / "map.simplemap", threeScans());
  const CSimpleMap back = io::readSimplemap(folder / "map.simplemap");
  ASSERT_EQ(back.size(), 3U);
  const auto last = std::next(back.begin(), 2);
  const auto pose = last->pose->getMeanVal();
  EXPECT_EQ(pose.x(), 2);
  EXPECT_EQ(pose.y(), 2);
  EXPECT_NEAR(pose.yaw(), 1, 1e-12);  // by way of a matrix
  const auto scan = last->sf->getObservationByClass<CObservation2DRangeScan>();
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->getScanSize(), 31U);
  EXPECT_EQ(scan->getScanRange(7), 3);
  EXPECT_TRUE(scan->getScanRangeValidity(7));
}

TEST_F(SimplemapFile, ParticlesOfRbpfSlamCountByTheirWeights) {
  auto particles = mrpt::poses::CPose3DPDFParticles::Create(2);
  particles->m_particles[0].d = {1, 0, 0, 0.2, 0, 0};
  particles->m_particles[1].d = {5, 4, 0, 0.2, 0, 0};
  particles->m_particles[1].log_w = std::log(3.0);
  CSimpleMap map;
  map.insert(particles, frameOf(scanOf(3)));
  io::writeWhole(folder / "a.simplemap", bytesOf(map));
  const CSimpleMap back = io::readSimplemap(folder / "a.simplemap");
  const auto pose = back.begin()->pose->getMeanVal();
  EXPECT_NEAR(pose.x(), 4, 1e-12);
  EXPECT_NEAR(pose.y(), 3, 1e-12);
  EXPECT_NEAR(pose.yaw(), 0.2, 1e-12);
}

TEST_F(SimplemapFile, EveryCutIsTold) {
  const std::string whole = bytesOf(threeScans());
  ASSERT_EQ(errorOf(whole), "");
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(errorOf(whole.substr(0, size)), "") << size;
  EXPECT_NE(errorOf(whole.substr(0, 700)).find("the file ends early"), std::string::npos);
}

TEST_F(SimplemapFile, CountsAreNotBelieved) {
  std::string bytes = bytesOf(threeScans());
  const std::size_t count = bytes.find("CSimpleMap") + std::string("CSimpleMap").size() + 1;
  bytes.replace(count, 4, "\xff\xff\xff\xff");
  EXPECT_NE(errorOf(bytes).find("entry 4"), std::string::npos) << errorOf(bytes);
}

TEST_F(SimplemapFile, OtherSensorsAreNamed) {
  CSimpleMap map;
  map.insert(mrpt::poses::CPose3DPDFGaussian::Create(CPose3D()),
             frameOf(mrpt::obs::CObservationOdometry::Create()));
  EXPECT_NE(errorOf(bytesOf(map)).find("CObservationOdometry"), std::string::npos);
}

TEST_F(SimplemapFile, NothingToGoOnFromIsAnError) {
  EXPECT_NE(errorOf(bytesOf({})).find("holds no laser scan"), std::string::npos);
  auto tilted = scanOf(2);
  tilted->sensorPose = CPose3D(0, 0, 0, 0, 0.5, 0);
  CSimpleMap map;
  map.insert(mrpt::poses::CPose3DPDFGaussian::Create(CPose3D()), frameOf(tilted));
  EXPECT_NE(errorOf(bytesOf(map)).find("holds no laser scan"), std::string::npos);
  EXPECT_NE(errorOf("FLASER 1 2 3").find("no simple map"), std::string::npos);
}
