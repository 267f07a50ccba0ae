#include "folder_steps.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"

namespace ariadne::experiment_app {

batch::Plan planFor(const Options& o) {
  batch::Experiment experiment = batch::readExperiment(o.ini);
  if (o.first) experiment.first_seed = *o.first;
  if (o.last) experiment.last_seed = *o.last;
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
