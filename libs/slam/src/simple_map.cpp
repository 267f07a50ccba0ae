#include "simple_map.h"

#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

namespace ariadne::slam {

using mrpt::math::TPose2D;

grid::OccupancyGrid gridOf(const mrpt::maps::CSimpleMap& known, const grid::GridParams& params) {
  grid::OccupancyGrid map(params);
  for (const auto& entry : known)
    for (const auto& observation : *entry.sf)
      if (const auto* scan =
              dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(observation.get()))
        map.insert(grid::makeScanShape(*scan, params), TPose2D(entry.pose->getMeanVal().asTPose()));
  return map;
}

mrpt::maps::CSimpleMap simpleMapOf(
    const mrpt::maps::CSimpleMap& known,
    const std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>& scans,
    const filter::AncestorPtr& leaf) {
  std::vector<TPose2D> poses(scans.size());
  filter::forEachAncestor(leaf, [&](const filter::Ancestor& a) {
    poses[a.step()] = a.pose();
    return true;
  });
  mrpt::maps::CSimpleMap map = known;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    auto frame = mrpt::obs::CSensoryFrame::Create();
    frame->insert(scans[i]);
    map.insert(mrpt::poses::CPose3DPDFGaussian::Create(mrpt::poses::CPose3D(poses[i])), frame);
  }
  return map;
}

}  // namespace ariadne::slam
