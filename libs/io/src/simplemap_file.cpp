#include "ariadne/io/simplemap_file.h"

#include <fmt/format.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <cmath>
#include <utility>

#include "ariadne/core/error.h"
#include "rawlog_objects.h"
#include "rawlog_poses.h"
#include "scan_check.h"

namespace ariadne::io {
namespace {

/// Of MRPT 2.12 and later: how fast the robot was, or nothing.
void passTwist(ArchiveReader& in) {
  if (in.text() != "std::optional") throw ArchiveDamage("no velocity where one should be");
  in.text();  // its type
  if (in.flag()) in.bytes(6 * sizeof(double));
}

/// The scans of a frame that lie along the floor and are possible.
mrpt::obs::CSensoryFrame::Ptr readFrame(ArchiveReader& in) {
  const ObjectHeader object = in.header("CSensoryFrame");
  if (object.version < 2) in.bytes(4);  // an ID
  if (object.version == 0) in.bytes(sizeof(std::int64_t));
  auto frame = mrpt::obs::CSensoryFrame::Create();
  for (auto left = in.number<std::uint32_t>(); left > 0; --left) {
    const ObjectHeader observation = in.header();
    if (observation.name != "CObservation2DRangeScan")
      throw ArchiveDamage(fmt::format(
          "a frame holds a {}, and only CObservation2DRangeScan is read of a simple map",
          observation.name));
    LaserRecord laser = readScan(in, observation);
    if (!repairGeometry(laser) || !isPlanar(*laser.scan)) continue;
    DatasetCounts counts;
    setBeams(*laser.scan, std::move(laser.beams), {}, counts);
    frame->insert(laser.scan);
  }
  in.end(object);
  return frame;
}

mrpt::maps::CSimpleMap readEntries(ArchiveReader& in, std::size_t& entry) {
  const ObjectHeader object = in.header("CSimpleMap");
  mrpt::maps::CSimpleMap map;
  const auto count = in.number<std::uint32_t>();
  for (entry = 1; entry <= count; ++entry) {
    const auto pose = object.version == 0 ? readDensity(in) : readDensity3D(in);
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.phi))
      throw ArchiveDamage("a pose is not finite");
    const auto frame = readFrame(in);
    if (object.version >= 2) passTwist(in);
    if (!frame->empty())
      map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(pose)), frame);
  }
  in.end(object);
  return map;
}

}  // namespace

mrpt::maps::CSimpleMap readSimplemap(const std::filesystem::path& path) {
  InputFile file(path);
  ArchiveReader in(file);
  if (in.nextClass() != "CSimpleMap")
    throw core::Error(fmt::format("{} is no simple map of MRPT (a map.simplemap)", path.string()));
  std::size_t entry = 0;
  mrpt::maps::CSimpleMap map;
  try {
    map = readEntries(in, entry);
  } catch (const ArchiveDamage& reason) {
    throw core::Error(fmt::format("{} is damaged at entry {}, byte {} (unpacked): {}",
                                  path.string(), entry, file.offset(), reason.what()));
  }
  if (map.empty())
    throw core::Error(fmt::format("{} holds no laser scan along the floor", path.string()));
  return map;
}

}  // namespace ariadne::io
