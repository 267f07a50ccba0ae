// What a keyframe shows besides the map.
#pragma once
#include "ariadne/report/replay_recorder.h"

namespace ariadne::report {

/// At most about `most`: of more every n-th, which a resampled set may be cut down to.
std::vector<ReplayParticle> drawnParticles(const FilterView& view, std::size_t most);

/// The line of s* from the root, points at least spacing_m apart; the last one always. The same
/// line gives the same points however far it has come.
std::vector<mrpt::math::TPoint2Df> drawnPath(const filter::AncestorPtr& leaf, double spacing_m);

ReplayGraph drawnGraph(const loops::PlaceGraph& graph);

}  // namespace ariadne::report
