#include "ariadne/experiment/run_figures.h"

namespace ariadne::experiment {
namespace {

void addArm(RunFigures& figures, const std::string& name, const ArmResult& arm) {
  const auto add = [&](const char* figure, double value) {
    figures.emplace_back(name + "_" + figure, value);
  };
  const auto addOfLoops = [&](const char* figure, double value) {
    add(figure, arm.true_closures > 0 ? value : kNone);
  };
  addOfLoops("exists", arm.exists);
  addOfLoops("chosen", arm.chosen);
  addOfLoops("correct_weight", arm.correct_weight);
  addOfLoops("translation_m", arm.worst_translation_m);
  addOfLoops("heading_deg", arm.worst_heading_deg);
  addOfLoops("best_translation_m", arm.best_translation_m);
  add("ate_m", arm.ate_m);
}

void addInner(RunFigures& figures, const InnerLoop& inner) {
  const RunFigures all = {{"existed_error_m", inner.existed_error_m},
                          {"saved_error_m", inner.saved_error_m},
                          {"left_error_m", inner.left_error_m},
                          {"survivors", inner.survivors},
                          {"distinct_left", inner.distinct_left},
                          {"distinct_saved", inner.distinct_saved},
                          {"kl_saved_nats", inner.kl_saved_nats},
                          {"kl_left_nats", inner.kl_left_nats},
                          {"lost_mass", inner.lost_mass},
                          {"neff_slope_per_m", inner.neff_slope_per_m},
                          {"resamplings", inner.resamplings},
                          {"recovery_s", inner.recovery_s},
                          {"ln_neff_new_per_10m", inner.ln_neff_new_per_10m},
                          {"ln_neff_once_per_10m", inner.ln_neff_once_per_10m},
                          {"ln_neff_twice_per_10m", inner.ln_neff_twice_per_10m},
                          {"ln_neff_more_per_10m", inner.ln_neff_more_per_10m}};
  figures.insert(figures.end(), all.begin(), all.end());
}

}  // namespace

RunFigures figuresOf(const LoopRunResult& result) {
  RunFigures figures;
  addArm(figures, "recovered", result.recovered);
  addArm(figures, "standard", result.standard);
  figures.emplace_back("true_closures", result.standard.true_closures);
  figures.emplace_back("closings", result.closings);
  figures.emplace_back("recoveries", result.recoveries);
  if (result.inner) addInner(figures, *result.inner);
  return figures;
}

RunFigures figuresOf(const OracleResult& result) {
  RunFigures figures;
  addArm(figures, "oracle", result.oracle);
  addArm(figures, "recovered", result.recovered);
  addArm(figures, "standard", result.standard);
  figures.emplace_back("true_closures", result.standard.true_closures);
  figures.emplace_back("recovered_kl_nats", result.kl_recovered_nats);
  figures.emplace_back("standard_kl_nats", result.kl_standard_nats);
  return figures;
}

}  // namespace ariadne::experiment
