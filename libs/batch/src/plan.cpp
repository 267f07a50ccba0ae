#include "ariadne/batch/plan.h"

#include <fmt/format.h>

#include <set>

#include "ariadne/batch/content_hash.h"
#include "ariadne/core/error.h"
#include "arm_call.h"
#include "resolved_config.h"

namespace ariadne::batch {
namespace {

constexpr double kMostRuns = 1e6;

std::vector<Combination> combinationsOf(const std::vector<Factor>& factors) {
  std::vector<Combination> all{{}};
  for (const Factor& factor : factors) {
    std::vector<Combination> longer;
    for (const Combination& c : all)
      for (const std::string& value : factor.values) {
        longer.push_back(c);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  return all;
}

/// What an arm's runs at one combination have in common.
struct Prepared {
  Program program;
  ArmCall call;
  std::string config;   ///< hash of the resolved INI
  std::string meaning;  ///< program and configuration, by content
};

class Planner {
 public:
  explicit Planner(const Experiment& experiment) : x_(experiment) {
    plan_.title = x_.title;
    plan_.ini = x_.text;
    plan_.figures = x_.figures;
    plan_.relative = x_.relative;
    plan_.success = x_.success;
    plan_.plots = x_.plots;
    plan_.limits = x_.limits;
    for (const Factor& factor : x_.factors) plan_.factors.push_back(factor.name);
    for (const Arm& arm : x_.arms)
      plan_.arms.push_back({arm.name, arm.prefix,
                            findProgram(arm.program, x_.file.parent_path(), arm.where),
                            truthOf(x_, arm)});
  }

  Plan run() {
    double runs = (static_cast<double>(x_.last_seed - x_.first_seed) + 1) *
                  static_cast<double>(x_.arms.size());
    for (const Factor& factor : x_.factors) runs *= static_cast<double>(factor.values.size());
    if (!(runs <= kMostRuns))
      throw core::UsageError(
          fmt::format("{}: {:.6g} runs are more than {:.0f}: fewer seeds or values?",
                      x_.file.string(), runs, kMostRuns));
    const auto combinations = combinationsOf(x_.factors);
    std::vector<Prepared> prepared;  // combination by combination, arm by arm
    for (const Combination& values : combinations)
      for (std::size_t arm = 0; arm < x_.arms.size(); ++arm)
        prepared.push_back(prepare(arm, values));
    for (std::uint64_t seed = x_.first_seed; seed <= x_.last_seed; ++seed) {
      auto next = prepared.begin();
      for (const Combination& values : combinations)
        for (std::size_t arm = 0; arm < x_.arms.size(); ++arm, ++next)
          plan_.runs.push_back(runOf(*next, seed, values, arm));
    }
    return std::move(plan_);
  }

 private:
  Prepared prepare(std::size_t index, const Combination& values) {
    const Arm& arm = x_.arms[index];
    Prepared p{plan_.arms[index].program, callOf(x_, arm, values), {}, {}};
    checkCall(arm, p.program, p.call);
    const std::string where = fmt::format("{}: [arm.{}]", arm.where, arm.name);
    const std::string config = resolvedConfig(p.program, p.call, where);
    p.config = hashOf(config);
    plan_.configs[p.config] = config;
    p.meaning = meaningOfWord(p.program.path.string(), hashes_, plan_.files) + "\n" +
                meaningOf(config, where, hashes_, plan_.files) +
                meaningOfWord(plan_.arms[index].truth, hashes_, plan_.files) + "\n";
    return p;
  }

  PlannedRun runOf(const Prepared& p, std::uint64_t seed, const Combination& values,
                   std::size_t arm) {
    PlannedRun run{seed, values, arm, {}, p.config, runArguments(p.program, p.call, seed)};
    std::string all = p.meaning;
    for (const std::string& word : run.arguments)
      all += meaningOfWord(word, hashes_, plan_.files) + "\n";
    run.key = hashOf(all);
    return run;
  }

  const Experiment& x_;
  Plan plan_;
  FileHashes hashes_;
};

}  // namespace

std::string describe(const Plan& plan, const PlannedRun& run) {
  std::string text = fmt::format("seed {}", run.seed);
  for (std::size_t i = 0; i < run.values.size(); ++i)
    text += fmt::format(", {} {}", plan.factors[i], run.values[i]);
  return text + ", " + plan.arms[run.arm].name;
}

std::vector<const PlannedRun*> distinctRuns(const Plan& plan) {
  std::vector<const PlannedRun*> runs;
  std::set<std::string> seen;
  for (const PlannedRun& run : plan.runs)
    if (seen.insert(run.key).second) runs.push_back(&run);
  return runs;
}

Plan planOf(const Experiment& experiment) { return Planner(experiment).run(); }

}  // namespace ariadne::batch
