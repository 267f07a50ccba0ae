#include "ariadne/explore/belief.h"

namespace ariadne::explore {

Belief beliefOf(const slam::Mapper& mapper, double time_s,
                const mrpt::obs::CObservation2DRangeScan& scan, bool touched) {
  const filter::Particle& best = mapper.particles()[mapper.particles().best()];
  return {time_s,        mapper.updates(),      mapper.pose(), best.map,
          best.ancestor, mapper.openClosings(), scan,          touched};
}

}  // namespace ariadne::explore
