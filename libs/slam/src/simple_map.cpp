#include "simple_map.h"

#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <tuple>

namespace ariadne::slam {

using mrpt::math::TPose2D;

namespace {

/// Pose and frame of an entry: a pair up to MRPT 2.5, a struct later.
template <class Entry>
auto partsOf(const Entry& e, int) -> decltype(std::tie(e.first, e.second)) {
  return std::tie(e.first, e.second);
}
template <class Entry>
auto partsOf(const Entry& e, long) -> decltype(std::tie(e.pose, e.sf)) {
  return std::tie(e.pose, e.sf);
}

}  // namespace

grid::OccupancyGrid gridOf(const mrpt::maps::CSimpleMap& known, const grid::GridParams& params) {
  grid::OccupancyGrid map(params);
  for (const auto& entry : known) {
    const auto [pose, frame] = partsOf(entry, 0);
    for (const auto& observation : *frame)
      if (const auto* scan =
              dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(observation.get()))
        map.insert(grid::makeScanShape(*scan, params), TPose2D(pose->getMeanVal().asTPose()));
  }
  return map;
}

mrpt::maps::CSimpleMap simpleMapOf(
    const std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>& scans,
    const filter::AncestorPtr& leaf) {
  std::vector<TPose2D> poses(scans.size());
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    poses[a.step()] = a.pose();
    return true;
  });
  mrpt::maps::CSimpleMap map;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scans[i]);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(poses[i])), frame);
  }
  return map;
}

}  // namespace ariadne::slam
