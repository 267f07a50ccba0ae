#include "comparison_output.h"

#include <fmt/format.h>
#include <mrpt/system/os.h>

#include <cmath>

namespace ariadne::compare_app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json spreadJson(const std::vector<double>& values) {
  const Spread s = spreadOf(values);
  return {{"median", s.median}, {"min", s.low}, {"max", s.high}, {"values", values}};
}

}  // namespace

std::string numberText(double value) {
  if (std::abs(value) >= 1000) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

std::string spreadText(const std::vector<double>& values) {
  const Spread s = spreadOf(values);
  if (s.low == s.high) return numberText(s.median);
  return fmt::format("{} ({} to {})", numberText(s.median), numberText(s.low), numberText(s.high));
}

std::string repeatsText(const Comparison& c) {
  const std::size_t repeats = c.figures.front().ours.size();
  if (repeats == 1) return "One run of each.";
  return fmt::format("Medians of {} runs, in brackets the least and the largest.", repeats);
}

std::string comparisonText(const Comparison& c, const std::vector<Requirement>& requirements) {
  std::string out = fmt::format("{}\n{}\n", c.settings, repeatsText(c));
  out += fmt::format("\n{:<22}{:>28}{:>28}{:>12}\n", "", "ariadne-slam", "stock MRPT", "ratio");
  for (const ComparedFigure& f : c.figures)
    out += fmt::format("{:<22}{:>28}{:>28}{:>12}   {}\n", f.kind.name(), spreadText(f.ours),
                       spreadText(f.stock), numberText(f.ratio()), f.kind.about);
  if (!requirements.empty()) out += "\n";
  for (const Requirement& r : requirements) {
    const double value = valueOf(c, r.name);
    out += fmt::format("{}: {} (it is {})\n", r.metBy(value) ? "met" : "NOT MET", r.text,
                       numberText(value));
  }
  return out;
}

Json comparisonJson(const Comparison& c, const std::vector<Requirement>& requirements) {
  Json figures = Json::object();
  for (const ComparedFigure& f : c.figures)
    figures[f.kind.name()] = {{"about", f.kind.about},
                              {"ours", spreadJson(f.ours)},
                              {"stock", spreadJson(f.stock)},
                              {"ratio", number(f.ratio())}};
  Json required = Json::array();
  for (const Requirement& r : requirements) {
    const double value = valueOf(c, r.name);
    required.push_back({{"text", r.text}, {"value", number(value)}, {"met", r.metBy(value)}});
  }
  return {{"program", "ariadne-compare"},
          {"versions", {{"ariadne", ARIADNE_VERSION}, {"mrpt", mrpt::system::MRPT_getVersion()}}},
          {"dataset", c.dataset},
          {"stock_ini", c.stock_base},
          {"settings", c.settings},
          {"repeats", c.figures.front().ours.size()},
          {"figures", figures},
          {"requirements", required}};
}

}  // namespace ariadne::compare_app
