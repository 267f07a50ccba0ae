// A plan and results made by hand: figures with known intervals.
#pragma once
#include <map>
#include <string>

#include "ariadne/batch/tables.h"

/// Two arms on ten seeds at each value of a factor (or without one): the first arm is right on
/// seeds 1 to 3, the second on all; figure x_m is the seed, of the second arm 10 more.
struct MadeExperiment {
  ariadne::batch::Plan plan;
  std::map<std::string, ariadne::batch::RunResult> results;

  explicit MadeExperiment(const std::vector<std::string>& values = {}) {
    plan.title = "T";
    plan.arms = {{"one", "", {}, ""}, {"two", "", {}, ""}};
    plan.figures = {"x_m"};
    plan.success = {"right", "!=", 0};
    if (!values.empty()) plan.factors = {"laps"};
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
      for (std::size_t v = 0; v < std::max<std::size_t>(1, values.size()); ++v)
        for (std::size_t arm = 0; arm < 2; ++arm)
          add(seed, values.empty() ? std::vector<std::string>{} : std::vector{values[v]}, arm);
  }

  void add(std::uint64_t seed, const std::vector<std::string>& values, std::size_t arm) {
    std::string key = std::to_string(seed) + (arm == 0 ? "a" : "b");
    for (const std::string& value : values) key += value;
    const std::string config = arm == 0 ? "c0" : "c1";
    plan.runs.push_back({seed, values, arm, key, config, {"@config"}});
    ariadne::batch::RunResult& r = results[key];
    r.key = key;
    r.figures = {{"right", arm == 1 || seed <= 3},
                 {"x_m", static_cast<double>(seed) + (arm == 1 ? 10 : 0)}};
  }

  /// No run of the arm at this value has a result.
  void forget(const std::string& value, std::size_t arm) {
    for (const auto& run : plan.runs)
      if (run.arm == arm && run.values[0] == value) results.erase(run.key);
  }

  std::vector<ariadne::batch::Cell> cells() const { return ariadne::batch::cellsOf(plan, results); }
};
