// What a Mapper has come to.
#include "ariadne/geometry/pose.h"
#include "ariadne/grid/map/conversion.h"
#include "mapper_impl.h"
#include "simple_map.h"

namespace ariadne::slam {

mrpt::maps::COccupancyGridMap2D Mapper::map() const {
  return grid::toMrpt(impl_->particles[impl_->particles.best()].map);
}

geometry::Trajectory Mapper::path() const { return pathOf(impl_->particles.best()); }

geometry::Trajectory Mapper::pathOf(std::size_t particle) const {
  return posePath(impl_->records, impl_->particles[particle].ancestor);
}

mrpt::math::TPose2D Mapper::pose() const {
  const mrpt::math::TPose2D& last = impl_->particles[impl_->particles.best()].map_from_robot;
  if (impl_->scans.empty()) return last;
  return geometry::compose(last, impl_->reckoning.sinceUpdate());
}

const filter::ParticleSet& Mapper::particles() const { return impl_->particles; }

mrpt::maps::CSimpleMap Mapper::simpleMap() const {
  return simpleMapOf(*impl_->known, impl_->scans,
                     impl_->particles[impl_->particles.best()].ancestor);
}

const std::vector<loops::PlaceGraph>& Mapper::graphs() const { return impl_->loops.graphs(); }
std::vector<loops::ClosingRecord> Mapper::closings() const { return impl_->loops.records(); }

const std::vector<loops::FoundClosure>& Mapper::foundClosures() const {
  return impl_->loops.found();
}
const models::MotionLearner& Mapper::learnedMotion() const { return impl_->particles.learned(); }

std::vector<const loops::Closing*> Mapper::openClosings() const {
  return impl_->loops.openClosings();
}

StageTimes Mapper::times() const { return impl_->times; }
std::size_t Mapper::updates() const { return impl_->scans.size(); }
const DoubtCounts& Mapper::doubts() const { return impl_->doubts; }

}  // namespace ariadne::slam
