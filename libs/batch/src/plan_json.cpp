#include "plan_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ariadne/batch/json_numbers.h"
#include "ariadne/core/error.h"

namespace ariadne::batch {
namespace {

using Json = nlohmann::ordered_json;

Json armJson(const PlannedArm& arm) {
  return {{"name", arm.name},
          {"prefix", arm.prefix},
          {"program", arm.program.path.string()},
          {"truth", arm.truth}};
}

PlannedArm armOf(const Json& json) {
  return {json.at("name"),
          json.at("prefix"),
          {json.at("program").get<std::string>()},
          json.at("truth")};
}

Json runJson(const PlannedRun& run) {
  return {{"key", run.key}, {"seed", run.seed},     {"values", run.values},
          {"arm", run.arm}, {"config", run.config}, {"arguments", run.arguments}};
}

PlannedRun runOf(const Json& json, const Plan& plan) {
  PlannedRun run{wholeOf<std::uint64_t>(json.at("seed"), "seed"),
                 json.at("values"),
                 wholeOf<std::size_t>(json.at("arm"), "arm"),
                 json.at("key"),
                 json.at("config"),
                 json.at("arguments")};
  if (run.arm >= plan.arms.size() || run.values.size() != plan.factors.size())
    throw core::Error("a run is of no arm or has not a value of every factor");
  return run;
}

}  // namespace

std::string planText(const Plan& plan) {
  Json json = {{"format", "ariadne-experiment plan 1"},
               {"title", plan.title},
               {"ini", plan.ini},
               {"factors", plan.factors},
               {"arms", Json::array()},
               {"figures", plan.figures},
               {"relative", plan.relative},
               {"success",
                {{"figure", plan.success.figure},
                 {"relation", plan.success.relation},
                 {"bound", plan.success.bound}}},
               {"plots", {{"figures", plan.plots.figures}, {"over", plan.plots.over}}},
               {"limits",
                {{"time_s", plan.limits.time_s},
                 {"threads", plan.limits.threads},
                 {"keep_files", plan.limits.keep_files}}},
               {"files", plan.files}};
  for (const PlannedArm& arm : plan.arms) json["arms"].push_back(armJson(arm));
  // A line a run: to be read by people, too.
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  text.erase(text.rfind('\n'));
  text += ",\n \"runs\": [";
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    text += (i == 0 ? "\n  " : ",\n  ") +
            runJson(plan.runs[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
  return text + "\n ]\n}\n";
}

Plan parsePlan(const std::string& text, const std::string& name) {
  try {
    const Json json = Json::parse(text);
    Plan plan;
    plan.title = json.at("title");
    plan.ini = json.value("ini", "");
    plan.factors = json.at("factors").get<std::vector<std::string>>();
    for (const Json& arm : json.at("arms")) plan.arms.push_back(armOf(arm));
    plan.figures = json.at("figures").get<std::vector<std::string>>();
    if (json.contains("relative"))  // not in plans of earlier versions
      plan.relative = json["relative"].get<std::vector<std::string>>();
    const Json& success = json.at("success");
    plan.success = {success.at("figure"), success.at("relation"), success.at("bound")};
    if (json.contains("plots"))  // not in plans of the first version
      plan.plots = {json["plots"].at("figures"), json["plots"].at("over")};
    const Json& limits = json.at("limits");
    plan.limits = {limits.at("time_s"), wholeOf<int>(limits.at("threads"), "threads"),
                   limits.at("keep_files")};
    plan.files = json.at("files").get<std::map<std::string, std::string>>();
    for (const Json& run : json.at("runs")) plan.runs.push_back(runOf(run, plan));
    return plan;
  } catch (const std::exception& e) {
    throw core::Error(fmt::format("{} is no plan of ariadne-experiment: {}", name, e.what()));
  }
}

}  // namespace ariadne::batch
