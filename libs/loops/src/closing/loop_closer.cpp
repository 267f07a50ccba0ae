#include "ariadne/loops/closing/loop_closer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/recovery/recover.h"
#include "recovery/closure_draw.h"
#include "set_figures.h"

namespace ariadne::loops {
namespace {

using Scans = LoopCloser::Scans;

/// Shapes of the scans after update `from`; empty ones before, which nobody needs.
std::vector<grid::ScanShape> shapesAfter(const Scans& scans, std::size_t from,
                                         const grid::GridParams& params,
                                         const core::Parallel& parallel) {
  std::vector<grid::ScanShape> shapes(scans.size());
  parallel.forEach(scans.size() - from, [&](std::size_t i) {
    shapes[from + i] = grid::makeScanShape(*scans[from + i], params);
  });
  return shapes;
}

std::size_t earliestCheckpoint(const SavedSet& saved) {
  std::size_t earliest = saved.te;
  for (const SavedEntry& e : saved.entries) earliest = std::min(earliest, e.checkpoint->step);
  return earliest;
}

FinderParams finderParams(const ClosingParams& p) {
  FinderParams out;
  out.least_path_m = p.opportunity.c2_m;
  out.longest_window_m = p.search_window_m;
  return out;
}

}  // namespace

LoopCloser::LoopCloser(const LoopCloserParams& params, const core::Parallel& parallel)
    : params_(params),
      parallel_(parallel),
      watcher_(params.closing),
      stack_(params.recovery.memory_budget_mb),
      finder_(finderParams(params.closing), params.grid, params.likelihood) {}

void LoopCloser::extend(const filter::ParticleSet& particles, const grid::Scan& scan) {
  if (!params_.closing.enabled) return;
  if (params_.closing.search) finder_.add(scan, particles.figures().motion_covariance);
  if (graphs_.empty()) {
    graphs_.resize(particles.size());
  } else if (particles.figures().resampled) {
    std::vector<PlaceGraph> next;
    for (const std::size_t parent : particles.parents()) next.push_back(graphs_[parent]);
    graphs_ = std::move(next);
  }
  parallel_.forEach(particles.size(), [&](std::size_t i) {
    const filter::Particle& p = particles[i];
    graphs_[i].extend({p.map_from_robot.x, p.map_from_robot.y}, p.map, params_.closing.places);
  });
}

ClosingStep LoopCloser::figuresOf(const filter::ParticleSet& particles, double neff) {
  const std::size_t update = particles.step() - 1;
  const filter::Ancestor& here = *particles[particles.best()].ancestor;
  double travelled = travelled_m_.empty() ? 0 : travelled_m_.back();
  if (const auto& before = here.parent())
    travelled += geometry::distance(here.pose(), before->pose());
  travelled_m_.push_back(travelled);
  past_.push_back({particles.poses(), filter::distinctAncestors(leavesOf(particles), update)});
  return {travelled, neff, static_cast<double>(particles.size()), particles.figures().resampled,
          spreadOf(past_.back().particles)};
}

LoopCloser::Watched LoopCloser::watch(const filter::ParticleSet& particles, double neff) {
  if (!params_.closing.enabled) return {};
  const std::size_t best = particles.best();
  const ClosingStep figures = figuresOf(particles, neff);
  const auto events = watcher_.observe({graphs_[best], particles[best].map, figures});
  LoopReport report;
  report.state = watcher_.state();
  if (const auto& opportunity = watcher_.opportunity()) {
    report.opportunities = opportunity->places.size();
    report.dist_m = opportunity->dist_m_m;
    report.dist_g = opportunity->dist_g_m;
  }
  report.unique_ancestors = uniqueAncestors(particles, particles.step() - 1);

  if (events.detected) save(*events.detected, particles);
  for (const std::size_t id : events.given_up) stack_.drop(id);
  if (events.entered) {
    const std::size_t te = watcher_.closings()[*events.entered].opportunity.te;
    for (auto& graph : graphs_) graph.close(graph.visits()[te].place);
  }
  return {report, events.ended};
}

/// Update at which unique ancestors are counted: te of the open closing, else one c2 of path back.
std::size_t LoopCloser::lookBack(std::size_t step) const {
  if (const Closing* open = watcher_.open()) return open->opportunity.te;
  const double from = travelled_m_.back() - params_.closing.opportunity.c2_m;
  std::size_t i = step;
  while (i > 0 && travelled_m_[i] > from) --i;
  return i;
}

/// At lookBack(). Lines merge at resamplings only, so that the count stays between them; a closing
/// of many laps would else walk them all at each update.
std::size_t LoopCloser::uniqueAncestors(const filter::ParticleSet& particles, std::size_t step) {
  const std::size_t at = lookBack(step);
  if (!unique_ || unique_->at != at || particles.figures().resampled)
    unique_ = {at, filter::distinctAncestors(leavesOf(particles), at)};
  return unique_->count;
}

void LoopCloser::save(std::size_t id, const filter::ParticleSet& particles) {
  outcomes_.resize(watcher_.closings().size());
  const std::size_t te = watcher_.closings()[id].opportunity.te;
  SavedSet set = loops::save(particles, graphs_, te);
  SavingRecord record;
  record.entries = set.entries.size();
  record.distinct_ancestors = set.distinctAncestors();
  record.existed = past_[te].distinct;
  record.at_te = past_[te].particles;
  record.saved = posesOf(set);
  record.memory_mb = static_cast<double>(set.mapBytes()) / 1e6;
  outcomes_[id].saving = std::move(record);
  for (const std::size_t dropped : stack_.push(id, std::move(set))) {
    outcomes_[dropped].dropped = true;
    outcomes_[dropped].note = fmt::format(
        "the saved set was dropped, so nothing was recovered: saved sets took more than "
        "recovery.memory_budget_mb = {}",
        params_.recovery.memory_budget_mb);
  }
}

void LoopCloser::recover(std::size_t id, filter::ParticleSet& particles, const Scans& scans) {
  auto saved = stack_.pop(id);
  Outcome& outcome = outcomes_[id];
  if (!saved) return;
  if (!params_.recovery.enabled) {
    outcome.note = "recovery is off";
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  const auto shapes = shapesAfter(scans, earliestCheckpoint(*saved), params_.grid, parallel_);
  RecoveredSet set = loops::recover(*saved, particles, graphs_,
                                    {shapes, params_.checkpoint_updates, params_.seed, parallel_},
                                    params_.recovery.draw);
  RecoveryRecord record;
  record.update = particles.step() - 1;
  record.before = leavesOf(particles);
  record.weights_before = particles.weights();
  record.distinct_before = filter::distinctAncestors(record.before, saved->te);
  record.distinct_sources = std::set<std::size_t>(set.sources.begin(), set.sources.end()).size();
  record.contradiction = std::move(set.contradiction);
  particles.replace(std::move(set.particles), set.weights);
  setGraphs(std::move(set.graphs));
  record.after = leavesOf(particles);
  record.distinct_after = filter::distinctAncestors(record.after, saved->te);
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.recovery = std::move(record);
}

void LoopCloser::search(filter::ParticleSet& particles, const Scans& scans) {
  if (!params_.closing.enabled || !params_.closing.search) return;
  const auto closure = finder_.look(particles[particles.best()].ancestor, scans);
  if (!closure) return;
  const auto start = std::chrono::steady_clock::now();
  // What was saved after the beginning belongs to paths that are replaced.
  outcomes_.resize(watcher_.closings().size());
  for (const Closing& c : watcher_.closings())
    if (c.opportunity.te > closure->begin && stack_.holds(c.id))
      outcomes_[c.id].note =
          "nothing was recovered: the paths were drawn anew, given a closure found from afar";
  stack_.dropAfter(closure->begin);
  const SavedSet present = loops::save(particles, graphs_, closure->begin);
  const auto shapes = shapesAfter(scans, earliestCheckpoint(present), params_.grid, parallel_);
  RecoveredSet set = drawGiven(*closure, finder_, present, particles, graphs_,
                               {shapes, params_.checkpoint_updates, params_.seed, parallel_});
  particles.replace(std::move(set.particles), set.weights);
  setGraphs(std::move(set.graphs));
  FoundClosure found;
  found.update = particles.step() - 1;
  found.anchor = closure->anchor;
  found.begin = closure->begin;
  found.correction_m = std::hypot(closure->correction.x, closure->correction.y);
  found.correction_deg = std::abs(closure->correction.phi) * 180 / M_PI;
  found.hit_share = closure->hit_share;
  found.second_share = closure->second_share;
  found.cost = closure->cost;
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  found_.push_back(found);
}

std::vector<ClosingRecord> LoopCloser::records() const {
  std::vector<ClosingRecord> records;
  for (const Closing& c : watcher_.closings()) {
    const Outcome& outcome = outcomes_[c.id];
    records.push_back({c, outcome.saving, outcome.recovery, outcome.note, outcome.dropped});
    std::string& note = records.back().note;
    if (!note.empty() || outcome.recovery) continue;
    note = c.ended ? "nothing was recovered: " + c.end_reason
                   : "still open at the end of the log: nothing was recovered";
  }
  return records;
}

}  // namespace ariadne::loops
