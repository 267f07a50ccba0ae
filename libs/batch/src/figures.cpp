#include "ariadne/batch/figures.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "ariadne/core/error.h"
#include "ariadne/eval/errors.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"

namespace ariadne::batch {
namespace {

using PlainJson = nlohmann::json;

void collect(const PlainJson& at, const std::string& name, int depth, Figures& figures) {
  if (depth > 100) throw core::Error("the JSON is nested deeper than 100");  // the stack has an end
  if (at.is_boolean())
    figures[name] = at.get<bool>() ? 1 : 0;
  else if (at.is_number() && std::isfinite(at.get<double>()))
    figures[name] = at.get<double>();
  else if (at.is_null())
    figures[name] = std::numeric_limits<double>::quiet_NaN();
  else if (at.is_object())
    for (const auto& [key, value] : at.items())
      if (key != "parameters")
        collect(value, name.empty() ? key : name + "." + key, depth + 1, figures);
}

/// Of poses at most this far apart in time one is interpolated, as ariadne-slam --truth does.
constexpr double kTruthGap_s = 1;

double ateOf(const std::filesystem::path& trajectory, const std::string& truth) {
  const auto pairs = eval::associate(io::readTum(trajectory), io::readTum(truth), kTruthGap_s);
  if (pairs.empty())
    throw core::Error(fmt::format("no pose of the trajectory has the time of one of {}", truth));
  return eval::figuresOf(eval::absoluteErrors(pairs, eval::align(pairs))).rmse;
}

}  // namespace

Figures figuresOfSummary(const std::string& text, const std::string& name) {
  try {
    Figures figures;
    collect(PlainJson::parse(text), "", 0, figures);
    return figures;
  } catch (const PlainJson::exception& e) {
    throw core::Error(fmt::format("{} is no JSON: {}", name, e.what()));
  }
}

Figures figuresOf(const PlannedArm& arm, const std::filesystem::path& out) {
  Figures figures = figuresOfSummary(io::readWhole(out / "summary.json"), "summary.json");
  if (!arm.truth.empty()) figures["ate_rmse_m"] = ateOf(out / "trajectory.tum", arm.truth);
  return figures;
}

}  // namespace ariadne::batch
