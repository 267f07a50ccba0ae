#include "loop_pictures.h"

#include <algorithm>

#include "ariadne/eval/ancestry_measures.h"
#include "ariadne/report/curves.h"
#include "ariadne/report/topology.h"

namespace ariadne::slam_app {
namespace {

report::Curve coalescence(const std::string& name, const std::vector<filter::AncestorPtr>& leaves,
                          std::size_t updates) {
  report::Curve curve{name, {}, {}};
  const auto unique = eval::uniqueAncestors(leaves, updates);
  for (std::size_t k = 0; k < unique.size(); ++k) {
    curve.x.push_back(static_cast<double>(k));
    curve.y.push_back(static_cast<double>(unique[k]));
  }
  return curve;
}

}  // namespace

void writeTopologyPicture(const std::filesystem::path& file, const slam::Mapper& mapper,
                          const mrpt::maps::COccupancyGridMap2D& map) {
  const topology::PlaceGraph& g = mapper.graphs()[mapper.particles().best()];
  report::DrawnGraph drawn;
  g.places().forEach([&](const topology::Place& p) { drawn.places.push_back(p.position); });
  g.edges().forEach([&](const topology::Edge& e) {
    // On a new way the next place is made as it is reached; a cycle is closed to one of before.
    const bool grows = g.places()[std::max(e.a, e.b)].step == e.step;
    (grows ? drawn.ways : drawn.shortcuts).emplace_back(e.a, e.b);
  });
  for (const slam::ClosingRecord& c : mapper.closings())
    if (c.closing.entered)
      drawn.entries.push_back(g.places()[g.visits()[c.closing.opportunity.te].place].position);
  report::writeTopology(file, map, drawn);
}

void writeCoalescencePicture(const std::filesystem::path& file, const slam::Mapper& mapper) {
  report::CurveChart chart;
  chart.title = "Unique ancestors of the particle set";
  chart.x_label = "filter update";
  chart.y_label = "ancestors at that update";
  std::vector<filter::AncestorPtr> leaves;
  for (std::size_t i = 0; i < mapper.particles().size(); ++i)
    leaves.push_back(mapper.particles()[i].ancestor);
  chart.curves.push_back(coalescence("of the final set", leaves, mapper.updates()));
  const auto closings = mapper.closings();
  const slam::ClosingRecord* last = nullptr;
  for (const slam::ClosingRecord& c : closings)
    if (c.recovery) last = &c;
  if (last) {
    const slam::RecoveryRecord& r = *last->recovery;
    chart.curves.push_back(coalescence("before the last recovery", r.before, r.update + 1));
    chart.curves.push_back(coalescence("after it", r.after, r.update + 1));
    chart.moments = {{"te", static_cast<double>(last->closing.opportunity.te)},
                     {"detection", static_cast<double>(last->closing.detected)},
                     {"recovery", static_cast<double>(r.update)}};
  }
  report::writeCurves(file, chart);
}

}  // namespace ariadne::slam_app
