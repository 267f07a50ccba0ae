#include "plan_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "ariadne/core/error.h"
#include "ariadne/statistics/plan.h"
#include "command_line.h"

namespace ariadne::eval_app {
namespace {

constexpr const char* kAbout =
    "How many runs tell two success rates apart: an arm for arms on seeds of their own (Fisher's\n"
    "exact test), or pairs for arms on the same seeds (McNemar's exact test). Two-sided.";

constexpr const char* kExamples =
    "Examples:\n"
    "  ariadne-eval plan 0.40 0.93 --power 0.9\n"
    "  ariadne-eval plan 0.40 0.93 --power 0.9 --paired\n"
    "  ariadne-eval plan 0.40 0.93 --paired --only-first 0.05\n"
    "Exit code: 0 fine, 2 wrong use.";

struct PlanArguments {
  double p1 = 0;
  double p2 = 0;
  statistics::PlanGoal goal;
  bool paired = false;
  std::optional<double> only_first;
  bool json = false;
};

void declare(CLI::App& app, PlanArguments& a) {
  app.footer(kExamples);
  app.add_option("RATE1", a.p1, "success rate of the first arm, 0 to 1")->required();
  app.add_option("RATE2", a.p2, "of the second")->required();
  app.add_option("--power", a.goal.power, "probability that the test finds the difference")
      ->capture_default_str();
  app.add_option("--level", a.goal.level, "significance level")->capture_default_str();
  auto* paired = app.add_flag("--paired", a.paired, "both arms run on the same seeds");
  app.add_option("--only-first", a.only_first,
                 "share of pairs in which only the first arm succeeds; default: as if the arms of "
                 "a pair were independent, RATE1 (1 - RATE2)")
      ->needs(paired);
  app.add_flag("--json", a.json, "as JSON");
}

void check(const PlanArguments& a) {
  for (const double p : {a.p1, a.p2})
    if (!(p >= 0 && p <= 1))
      throw core::UsageError(fmt::format("a rate of {} is not in [0, 1]", p));
}

/// Shares of pairs in which only the one or the other succeeds: their difference is the rates'.
struct Discordant {
  double first = 0;
  double second = 0;
};

Discordant discordantOf(const PlanArguments& a) {
  // Each of first, second, both (p1 - first) and none (1 - second - p1) is a probability.
  const double least = std::max(0.0, a.p1 - a.p2);
  const double most = std::min(a.p1, 1 - a.p2);
  const double first = a.only_first.value_or(a.p1 * (1 - a.p2));
  if (!(first >= least && first <= most))
    throw core::UsageError(
        fmt::format("--only-first {}: with rates of {} and {} it is between {:.6g} and {:.6g}",
                    first, a.p1, a.p2, least, most));
  return {first, first + a.p2 - a.p1};
}

std::string powerText(const statistics::Plan& plan) {
  return plan.exact ? fmt::format("power {:.4f}, exact", plan.power)
                    : "by the normal formula: too many for exact sums";
}

}  // namespace

int runPlan(const std::vector<std::string>& args, std::ostream& out) {
  CLI::App app(kAbout, "ariadne-eval plan");
  PlanArguments a;
  declare(app, a);
  if (!app::parseCommandLine(app, args, out)) return 0;
  check(a);
  const Discordant d = discordantOf(a);
  const statistics::Plan plan = a.paired ? statistics::planPaired(d.first, d.second, a.goal)
                                         : statistics::planUnpaired(a.p1, a.p2, a.goal);
  if (a.json) {
    nlohmann::ordered_json json{{"test", a.paired ? "McNemar" : "Fisher"},
                                {"rates", {a.p1, a.p2}},
                                {"level", a.goal.level},
                                {"wanted_power", a.goal.power},
                                {a.paired ? "pairs" : "runs_an_arm", plan.runs},
                                {"power", plan.power},
                                {"exact", plan.exact}};
    if (a.paired) json["discordant_shares"] = {d.first, d.second};
    out << json.dump(2) << '\n';
  } else if (a.paired) {
    out << fmt::format(
        "{} pairs ({})\nMcNemar's exact test at {:g}, two-sided, {:.4f} of the pairs won by the "
        "first arm alone\nand {:.4f} by the second alone{}\n",
        plan.runs, powerText(plan), a.goal.level, d.first, d.second,
        a.only_first ? "" : " (as if the arms of a pair were independent; --only-first)");
  } else {
    out << fmt::format("{} runs an arm, {} in all ({})\nFisher's exact test at {:g}, two-sided\n",
                       plan.runs, 2 * plan.runs, powerText(plan), a.goal.level);
  }
  return 0;
}

}  // namespace ariadne::eval_app
