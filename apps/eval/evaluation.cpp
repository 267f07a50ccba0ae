#include "evaluation.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/eval/loop_errors.h"
#include "ariadne/eval/relations.h"
#include "ariadne/io/relations.h"
#include "ariadne/io/tum.h"

namespace ariadne::eval_app {
namespace {

std::string range(double from_s, double to_s) {
  return fmt::format("{:.2f} to {:.2f} s", from_s, to_s);
}

std::vector<double> headingErrors(const std::vector<eval::PosePair>& pairs, double turn) {
  std::vector<double> errors;
  for (const auto& p : pairs)
    errors.push_back(std::abs(std::remainder(p.estimate.phi + turn - p.truth.phi, 2 * M_PI)) * 180 /
                     M_PI);
  return errors;
}

void acrossClosures(TruthResult& r, const Arguments& args, const geometry::Trajectory& estimate,
                    const geometry::Trajectory& truth) {
  const auto errors = eval::loopErrors(estimate, truth, args.max_gap_s);
  std::vector<double> translations;
  std::vector<double> headings;
  for (const eval::LoopError& e : errors.closures) {
    translations.push_back(e.translation_m);
    headings.push_back(e.heading_deg);
  }
  r.closures = errors.closures.size() + errors.unmatched;
  r.unmatched_closures = errors.unmatched;
  if (translations.empty()) return;
  r.closure_m = eval::figuresOf(translations);
  r.closure_deg = eval::figuresOf(headings);
}

TruthResult againstTruth(const Arguments& args, const geometry::Trajectory& estimate) {
  const auto truth = io::readTum(args.truth);
  TruthResult r;
  r.truth_poses = truth.size();
  r.pairs = eval::associate(estimate, truth, args.max_gap_s);
  if (r.pairs.empty())
    throw core::Error(fmt::format(
        "{} ({}) and {} ({}) have no time in common; is it the same run? (--max-gap {} s)",
        args.estimate, range(estimate.front().time_s, estimate.back().time_s), args.truth,
        range(truth.front().time_s, truth.back().time_s), args.max_gap_s));
  r.truth_from_estimate = eval::align(r.pairs);
  r.distances_m = eval::absoluteErrors(r.pairs, r.truth_from_estimate);
  r.absolute_m = eval::figuresOf(r.distances_m);
  r.heading_deg = eval::figuresOf(headingErrors(r.pairs, r.truth_from_estimate.phi));
  const auto relative = eval::relativeErrors(r.pairs, args.delta_m);
  r.relative_m = eval::figuresOf(relative.translation_m);
  r.relative_deg = eval::figuresOf(relative.rotation_deg);
  acrossClosures(r, args, estimate, truth);
  return r;
}

RelationResult againstRelations(const Arguments& args, const geometry::Trajectory& estimate) {
  const auto relations = io::readRelations(args.relations);
  const auto errors = eval::relationErrors(estimate, relations, args.max_gap_s);
  if (errors.translation_m.empty())
    throw core::Error(
        fmt::format("none of the {} relations of {} lies within {} ({}); --max-gap {} s",
                    relations.size(), args.relations, args.estimate,
                    range(estimate.front().time_s, estimate.back().time_s), args.max_gap_s));
  return {errors.unmatched, eval::figuresOf(errors.translation_m),
          eval::figuresOf(errors.rotation_deg)};
}

nlohmann::json toJson(const eval::ErrorFigures& f) {
  return {{"count", f.count}, {"mean", f.mean},     {"deviation", f.deviation},
          {"rmse", f.rmse},   {"median", f.median}, {"max", f.max}};
}

std::string row(const char* name, const char* unit, const eval::ErrorFigures& f) {
  return fmt::format("{:<28}{:>5}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>10.4f}{:>8}\n", name, unit,
                     f.rmse, f.mean, f.deviation, f.median, f.max, f.count);
}

}  // namespace

Evaluation evaluate(const Arguments& args) {
  const auto estimate = io::readTum(args.estimate);
  Evaluation e;
  e.estimated_poses = estimate.size();
  if (!args.truth.empty()) e.truth = againstTruth(args, estimate);
  if (!args.relations.empty()) e.relations = againstRelations(args, estimate);
  return e;
}

void printText(const Arguments& args, const Evaluation& e, std::ostream& out) {
  out << fmt::format("{:<33}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}\n", "", "RMSE", "mean", "deviation",
                     "median", "max", "count");
  if (e.truth) {
    out << row("ATE, position", "m", e.truth->absolute_m)
        << row("ATE, heading", "deg", e.truth->heading_deg)
        << row(fmt::format("RPE over {:g} m, position", args.delta_m).c_str(), "m",
               e.truth->relative_m)
        << row(fmt::format("RPE over {:g} m, heading", args.delta_m).c_str(), "deg",
               e.truth->relative_deg);
    if (e.truth->closures > e.truth->unmatched_closures)
      out << row("across loops, position", "m", e.truth->closure_m)
          << row("across loops, heading", "deg", e.truth->closure_deg);
  }
  if (e.relations)
    out << row("relations, translation", "m", e.relations->translation_m)
        << row("relations, rotation", "deg", e.relations->rotation_deg);
  if (e.truth)
    out << fmt::format(
        "\n{} of {} true poses have an estimate; laid over the truth by a turn of "
        "{:.3f} deg and a shift of ({:.3f}, {:.3f}) m.\n",
        e.truth->pairs.size(), e.truth->truth_poses, e.truth->truth_from_estimate.phi * 180 / M_PI,
        e.truth->truth_from_estimate.x, e.truth->truth_from_estimate.y);
  if (e.relations && e.relations->unmatched > 0)
    out << fmt::format("{} relations are outside the trajectory or in a gap of it.\n",
                       e.relations->unmatched);
}

void printJson(const Evaluation& e, std::ostream& out) {
  nlohmann::json json{{"estimated_poses", e.estimated_poses}};
  if (e.truth) {
    const auto& t = *e.truth;
    json["truth"] = {{"poses", t.truth_poses},
                     {"pairs", t.pairs.size()},
                     {"truth_from_estimate",
                      {{"x_m", t.truth_from_estimate.x},
                       {"y_m", t.truth_from_estimate.y},
                       {"turn_deg", t.truth_from_estimate.phi * 180 / M_PI}}},
                     {"ate_m", toJson(t.absolute_m)},
                     {"ate_heading_deg", toJson(t.heading_deg)},
                     {"rpe_m", toJson(t.relative_m)},
                     {"rpe_heading_deg", toJson(t.relative_deg)},
                     {"closures",
                      {{"count", t.closures},
                       {"unmatched", t.unmatched_closures},
                       {"error_m", toJson(t.closure_m)},
                       {"error_heading_deg", toJson(t.closure_deg)}}}};
  }
  if (e.relations)
    json["relations"] = {{"unmatched", e.relations->unmatched},
                         {"translation_m", toJson(e.relations->translation_m)},
                         {"rotation_deg", toJson(e.relations->rotation_deg)}};
  out << json.dump(2) << '\n';
}

}  // namespace ariadne::eval_app
