#include "ariadne/loops/closing/loop_watcher.h"

#include <algorithm>
#include <cmath>

namespace ariadne::loops {

void validate(const ClosingParams& params, const std::string& section) {
  core::validateFields(params, section);
  validate(params.opportunity, section);
}

namespace {

const ClosingParams& validated(const ClosingParams& params) {
  validate(params, "loop_closing");
  return params;
}

}  // namespace

LoopWatcher::LoopWatcher(const ClosingParams& params)
    : params_(validated(params)), rule_(stopRule(params)) {}

const Closing* LoopWatcher::open() const {
  return open_.empty() ? nullptr : &closings_[open_.back()];
}

std::vector<const Closing*> LoopWatcher::allOpen() const {
  std::vector<const Closing*> all;
  for (const std::size_t id : open_) all.push_back(&closings_[id]);
  return all;
}

LoopState LoopWatcher::state() const {
  if (!open()) return LoopState::exploring;
  return open()->entered ? LoopState::closing : LoopState::approaching;
}

LoopEvents LoopWatcher::observe(const WatchedStep& step) {
  travelled_m_.push_back(step.figures.travelled_m);
  uncertainty_m_.push_back(step.figures.uncertainty_m);
  LoopEvents events;
  detect(step, events);
  approach(step, events);
  follow(step, events);
  return events;
}

/// Hysteresis: within one closed loop no path is a loop again.
bool LoopWatcher::counts(const Place& place, const WatchedStep& step) const {
  const std::size_t here = step.graph.places()[step.graph.visits().back().place].step;
  return std::none_of(closed_.begin(), closed_.end(), [&](const Interval& loop) {
    return loop.first <= here && here <= loop.last && loop.first <= place.step &&
           place.step <= loop.last;
  });
}

void LoopWatcher::detect(const WatchedStep& step, LoopEvents& events) {
  opportunity_.reset();
  if (quiet_until_m_ && step.figures.travelled_m < *quiet_until_m_) return;
  const auto& position = step.graph.visits().back().position;
  opportunity_ = findOpportunity(step.graph, step.map, position, params_.opportunity,
                                 [&](const Place& place) { return counts(place, step); });
  if (!opportunity_ || state() == LoopState::approaching) return;
  Closing closing;
  closing.id = closings_.size();
  closing.opportunity = *opportunity_;
  closing.entry_position = step.graph.places()[opportunity_->entry].position;
  closing.detected = travelled_m_.size() - 1;
  closing.course.loop_length_m = step.figures.travelled_m - travelled_m_[opportunity_->te];
  closing.course.uncertainty_at_te_m = uncertainty_m_[opportunity_->te];
  open_.push_back(closing.id);
  events.detected = closing.id;
  closings_.push_back(std::move(closing));
}

/// s* may have changed since the detection, so places are told by the update at which they were
/// visited: the robot is back when it is at a place from about te.
bool LoopWatcher::atEntry(const Closing& closing, const PlaceGraph& graph) const {
  const Visit& here = graph.visits().back();
  if (!here.inside) return false;
  const std::size_t te = closing.opportunity.te;
  if (here.place == graph.visits()[te].place) return true;
  const std::size_t made = graph.places()[here.place].step;
  return made < closing.detected &&
         travelled_m_[closing.detected] - travelled_m_[made] > params_.opportunity.c2_m &&
         std::abs(travelled_m_[made] - travelled_m_[te]) < params_.opportunity.c1_m;
}

void LoopWatcher::approach(const WatchedStep& step, LoopEvents& events) {
  if (state() != LoopState::approaching) return;
  Closing& closing = closings_[open_.back()];
  const std::size_t update = travelled_m_.size() - 1;
  if (atEntry(closing, step.graph)) {
    closing.entered = update;
    closing.last_known_m = step.figures.travelled_m;
    events.entered = closing.id;
  } else if (step.figures.travelled_m - travelled_m_[closing.detected] > params_.approach_limit_m) {
    events.given_up.push_back(closing.id);
    end(closing.id, "the robot did not come to the entry", update);
  }
}

std::string LoopWatcher::reasonToEnd(Closing& closing, const WatchedStep& step) const {
  const Visit& here = step.graph.visits().back();
  // Places made on the last metres before the entry belong to the loop.
  if (here.inside && step.graph.places()[here.place].step <= *closing.entered)
    closing.last_known_m = step.figures.travelled_m;
  closing.course.steps.push_back(step.figures);
  const double driven = closing.course.driven_m();
  const auto note = [&](std::optional<double>& at, Stop stop) {
    ClosingParams with = params_;
    with.stop = stop;
    if (!at && stopRule(with)(closing.course)) at = driven;
  };
  note(closing.neff_rule_m, Stop::neff);
  note(closing.slope_rule_m, Stop::neff_slope);
  if (rule_(closing.course)) {
    switch (params_.stop) {
      case Stop::neff:
        return "Neff constant";
      case Stop::neff_slope:
        return "ln Neff flat";
      case Stop::uncertainty:
        return "pose as certain as at the entry";
      case Stop::path_end:
        return "the loop's length driven";
      case Stop::laps:
        return "laps driven";
      case Stop::leaving:
      case Stop::never:
        break;
    }
  }
  const bool left = step.figures.travelled_m - closing.last_known_m > params_.leave_after_m;
  return left && params_.stop != Stop::never ? "the robot left what it knew" : "";
}

/// Every closing in which the robot is; when an outer one ends, those within it end with it.
void LoopWatcher::follow(const WatchedStep& step, LoopEvents& events) {
  const std::vector<std::size_t> ids = open_;
  for (const std::size_t id : ids) {
    if (!closings_[id].entered || events.ended) continue;
    const std::string reason = reasonToEnd(closings_[id], step);
    if (reason.empty()) continue;
    end(id, reason, travelled_m_.size() - 1);
    events.ended = id;
  }
}

void LoopWatcher::end(std::size_t id, const std::string& reason, std::size_t update) {
  const auto first = std::find(open_.begin(), open_.end(), id);
  for (auto it = first; it != open_.end(); ++it) {
    Closing& closing = closings_[*it];
    closing.ended = update;
    closing.end_reason = *it == id ? reason : "the loop around it ended";
    if (closing.entered) closed_.push_back({closing.opportunity.te, update});
  }
  open_.erase(first, open_.end());
  quiet_until_m_ = travelled_m_[update] + params_.cooldown_m;
}

}  // namespace ariadne::loops
