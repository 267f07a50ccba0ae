#include "loops_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ariadne/eval/kl_divergence.h"
#include "loop_counts.h"

namespace ariadne::slam_app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kContradicts = 0.2;  // share of beams in what the older map has as surely free

Json definitions() {
  const eval::KernelParams k;
  return {
      {"distinct_ancestors",
       "nodes of the ancestry at te: hypotheses that differ in what they were up to there"},
      {"survivors_fraction",
       "distinct ancestors at te of the saved set over the distinct hypotheses there were at te"},
      {"kl_nats",
       fmt::format("KL(true set at te || saved set) in nats, at the true set's samples, both as "
                   "Gaussian kernel densities of (x, y) with bandwidth {} m, no density under that "
                   "of one kernel at {} bandwidths; the true set was stored live",
                   k.bandwidth_m, k.floor_bandwidths)},
      {"lost_mass",
       fmt::format("weight of the true set's samples with no saved sample within {} bandwidths",
                   k.lost_bandwidths)},
      {"contradicting_particles",
       fmt::format("recovered particles of which over {} of the beams of the attached path end "
                   "where their own older map is surely free",
                   kContradicts)},
      {"neff_rule_m", "distance after the entry at which the paper's rule would have stopped"},
      {"slope_rule_m", "the same of the rule on the slope of ln Neff"},
      {"found",
       "closures that were searched for and found from metres away; every particle's path was then "
       "drawn "
       "anew, given the closure"},
      {"hit_share", "share of the last metres' beams that end on what was mapped there before"},
      {"cost", "half the squared Mahalanobis distance of the correction that s* needed"}};
}

Json moment(std::size_t update, const std::vector<slam::StepReport>& reports) {
  return {{"update", update}, {"time_s", reports[update].time_s}};
}

Json momentOrNull(const std::optional<std::size_t>& update,
                  const std::vector<slam::StepReport>& reports) {
  return update ? moment(*update, reports) : Json();
}

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json savingOf(const loops::SavingRecord& s) {
  const eval::Divergence d =
      eval::divergence({s.at_te.poses, s.at_te.weights}, {s.saved.poses, s.saved.weights});
  return {{"entries", s.entries},
          {"distinct_ancestors", s.distinct_ancestors},
          {"existed_at_te", s.existed},
          {"survivors_fraction",
           static_cast<double>(s.distinct_ancestors) / static_cast<double>(s.existed)},
          {"kl_nats", d.kl_nats},
          {"lost_mass", d.lost_mass},
          {"memory_mb", s.memory_mb}};
}

Json recoveryOf(const loops::RecoveryRecord& r) {
  const auto worst = std::max_element(r.contradiction.begin(), r.contradiction.end());
  return {
      {"update", r.update},
      {"distinct_ancestors_before", r.distinct_before},
      {"distinct_ancestors_after", r.distinct_after},
      {"distinct_ways_drawn", r.distinct_sources},
      {"contradicting_particles", std::count_if(r.contradiction.begin(), r.contradiction.end(),
                                                [](double share) { return share > kContradicts; })},
      {"largest_contradiction", worst == r.contradiction.end() ? 0 : *worst},
      {"seconds", r.seconds}};
}

/// Why x_te is where it is, Eq. (7) and (9), with the bounds of this run.
std::string whyThere(std::size_t places, const loops::OpportunityParams& bounds) {
  return fmt::format(
      "{} with dist_m < c1 = {} m and dist_G > c2 = {} m: Eq. (7) and (9)",
      places == 1 ? "the only place" : fmt::format("nearest by the map of {} places", places),
      bounds.c1_m, bounds.c2_m);
}

Json foundOf(const loops::FoundClosure& f, const std::vector<slam::StepReport>& reports) {
  return {{"found", moment(f.update, reports)},
          {"place", moment(f.anchor, reports)},
          {"drawn_from", moment(f.begin, reports)},
          {"correction_m", f.correction_m},
          {"correction_deg", f.correction_deg},
          {"hit_share", f.hit_share},
          {"second_share", f.second_share},
          {"cost", f.cost},
          {"seconds", f.seconds}};
}

Json closingOf(const loops::ClosingRecord& record, const std::vector<slam::StepReport>& reports,
               const loops::OpportunityParams& bounds) {
  const loops::Closing& c = record.closing;
  Json detection = moment(c.detected, reports);
  detection["opportunities"] = c.opportunity.places.size();
  detection["dist_m_m"] = c.opportunity.dist_m_m;
  detection["dist_g_m"] = c.opportunity.dist_g_m;
  detection["loop_length_m"] = c.course.loop_length_m;
  Json end = momentOrNull(c.ended, reports);
  if (c.ended) end["reason"] = c.end_reason;
  return {{"closing", c.id},
          {"detection", detection},
          {"te", moment(c.opportunity.te, reports)},
          {"entry",
           {{"x_m", c.entry_position.x},
            {"y_m", c.entry_position.y},
            {"why", whyThere(c.opportunity.places.size(), bounds)}}},
          {"entered", momentOrNull(c.entered, reports)},
          {"end", end},
          {"saved", record.saving ? savingOf(*record.saving) : Json()},
          {"neff_rule_m", orNull(c.neff_rule_m)},
          {"slope_rule_m", orNull(c.slope_rule_m)},
          {"recovery", record.recovery ? recoveryOf(*record.recovery) : Json()},
          {"note", record.note.empty() ? Json() : Json(record.note)}};
}

}  // namespace

std::string loopsJson(const std::vector<loops::ClosingRecord>& closings,
                      const std::vector<loops::FoundClosure>& found,
                      const std::vector<slam::StepReport>& reports,
                      const loops::OpportunityParams& bounds) {
  const LoopCounts n = countLoops(closings);
  Json json = {{"definitions", definitions()},
               {"detected", n.detected},
               {"closed", n.closed},
               {"recovered", n.recovered},
               {"found_from_afar", found.size()},
               {"closings", Json::array()},
               {"found", Json::array()}};
  for (const loops::ClosingRecord& c : closings)
    json["closings"].push_back(closingOf(c, reports, bounds));
  for (const loops::FoundClosure& f : found) json["found"].push_back(foundOf(f, reports));
  return json.dump(2) + "\n";
}

std::vector<std::string> loopWarnings(const std::vector<loops::ClosingRecord>& closings) {
  std::vector<std::string> warnings;
  for (const loops::ClosingRecord& c : closings)
    if (c.dropped) warnings.push_back(fmt::format("closing {}: {}", c.closing.id, c.note));
  return warnings;
}

}  // namespace ariadne::slam_app
