#include "loop_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/charts/curves.h"
#include "ariadne/eval/ancestry_measures.h"
#include "ariadne/report/topology.h"

namespace ariadne::slam_app {
namespace {

charts::Curve coalescence(const std::string& name, const std::vector<filter::AncestorPtr>& leaves,
                          std::size_t updates) {
  charts::Curve curve;
  curve.name = name;
  const auto unique = eval::uniqueAncestors(leaves, updates);
  for (std::size_t k = 0; k < unique.size(); ++k) {
    curve.x.push_back(static_cast<double>(k));
    curve.y.push_back(static_cast<double>(unique[k]));
  }
  return curve;
}

/// What there was just before the recovery (and would have been left without it), dashed, and just
/// after, in one colour.
void addRecovery(charts::CurveChart& chart, const loops::ClosingRecord& c) {
  const loops::RecoveryRecord& r = *c.recovery;
  const std::size_t colour = chart.curves.size() / 2 + 1;
  const auto add = [&](const char* when, const std::vector<filter::AncestorPtr>& leaves) {
    chart.curves.push_back(
        coalescence(fmt::format("{} recovery {}", when, c.closing.id), leaves, r.update + 1));
    chart.curves.back().colour = colour;
  };
  add("before", r.before);
  chart.curves.back().dashed = true;
  add("after", r.after);
  const auto mark = [&](const char* what, std::size_t update) {
    chart.moments.push_back(
        {fmt::format("{} {}", what, c.closing.id), static_cast<double>(update)});
  };
  mark("te", c.closing.opportunity.te);
  mark("recovery", r.update);
}

}  // namespace

void writeTopologyPicture(const std::filesystem::path& file, const slam::Mapper& mapper,
                          const mrpt::maps::COccupancyGridMap2D& map) {
  const loops::PlaceGraph& g = mapper.graphs()[mapper.particles().best()];
  report::DrawnGraph drawn;
  g.places().forEach([&](const loops::Place& p) { drawn.places.push_back(p.position); });
  g.edges().forEach([&](const loops::Edge& e) {
    // On new ground the next place is made as it is reached; a cycle is closed to one of before.
    const bool grows = g.places()[std::max(e.a, e.b)].step == e.step;
    (grows ? drawn.edges : drawn.shortcuts).emplace_back(e.a, e.b);
  });
  for (const loops::ClosingRecord& c : mapper.closings())
    if (c.closing.entered)
      drawn.entries.push_back(
          {g.places()[g.visits()[c.closing.opportunity.te].place].position, c.closing.id});
  report::writeTopology(file, map, drawn);
}

void writeCoalescencePicture(const std::filesystem::path& file, const slam::Mapper& mapper) {
  charts::CurveChart chart;
  chart.title = "Unique ancestors of the particle set";
  chart.x_label = "filter update";
  chart.y_label = "ancestors at that update";
  std::vector<filter::AncestorPtr> leaves;
  for (std::size_t i = 0; i < mapper.particles().size(); ++i)
    leaves.push_back(mapper.particles()[i].ancestor);
  chart.curves.push_back(coalescence("of the final set", leaves, mapper.updates()));
  for (const loops::ClosingRecord& c : mapper.closings())
    if (c.recovery) addRecovery(chart, c);
  charts::writeCurves(file, chart);
}

}  // namespace ariadne::slam_app
