#include "folder_steps.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/io/ini_text.h"
#include "ini_program.h"

namespace ariadne::experiment_app {

namespace {

/// "world=small,eight".
void keepOnly(batch::Experiment& experiment, const std::string& where) {
  const std::size_t equals = std::min(where.find('='), where.size());
  std::vector<std::string> names;
  for (batch::Factor& factor : experiment.factors) {
    names.push_back(factor.name);
    if (factor.name != where.substr(0, equals)) continue;
    const auto kept = equals < where.size() ? batch::splitList(where.substr(equals + 1), ",")
                                            : std::vector<std::string>();
    for (const std::string& value : kept)
      if (std::find(factor.values.begin(), factor.values.end(), value) == factor.values.end())
        throw core::UsageError(
            fmt::format("--where {}: {} is none of the values {}; the nearest is {}", where, value,
                        fmt::join(factor.values, ", "), core::nearestName(value, factor.values)));
    if (kept.empty())
      throw core::UsageError(fmt::format("--where {}: takes FACTOR=VALUE,..., as {}={}", where,
                                         factor.name, factor.values[0]));
    factor.values = kept;
    return;
  }
  throw core::UsageError(
      fmt::format("--where {}: the experiment has no such factor{}", where,
                  names.empty() ? "" : ", but " + fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

batch::Plan planFor(const Options& o) {
  app::expectIniOf("ariadne-experiment", o.ini, io::readIniText(o.ini));
  batch::Experiment experiment = batch::readExperiment(o.ini);
  if (o.first) experiment.first_seed = *o.first;
  if (o.last) experiment.last_seed = *o.last;
  for (const std::string& where : o.where) keepOnly(experiment, where);
  if (experiment.last_seed < experiment.first_seed)
    throw core::UsageError(fmt::format("last seed {} is before first seed {}", experiment.last_seed,
                                       experiment.first_seed));
  return batch::planOf(experiment);
}

std::set<std::string> forgetFailed(const batch::Plan& plan, const batch::Store& store) {
  std::set<std::string> keys;
  for (const auto& [key, result] : store.results(plan)) {
    if (result.failure.empty()) continue;
    store.forget(key);
    keys.insert(key);
  }
  return keys;
}

}  // namespace ariadne::experiment_app
