#include "eval_app.h"

#include <ostream>
#include <utility>

#include "ariadne/core/error.h"
#include "command_line.h"
#include "error_plot.h"
#include "evaluation.h"
#include "neff_command.h"
#include "plan_command.h"
#include "run_program.h"
#include "weights_command.h"

namespace ariadne {
namespace {

constexpr const char* kAbout =
    "How far an estimated trajectory is from the truth: ATE and RPE after laying one over the "
    "other\n"
    "(rotation and shift); the error across each place where the true path comes back to itself;\n"
    "and the relations error of Kuemmerle et al. (2009).";

constexpr const char* kExamples =
    "Examples:\n"
    "  ariadne-eval run/trajectory.tum truth.tum\n"
    "  ariadne-eval run/trajectory.tum truth.tum --plot errors.png\n"
    "  ariadne-eval run/trajectory.tum --relations intel.relations.gz --max-gap 0.001\n"
    "  ariadne-eval run/trajectory.tum truth.tum --json\n"
    "  ariadne-eval plan 0.40 0.93 --power 0.9 --paired    runs needed (see ariadne-eval plan "
    "--help)\n"
    "  ariadne-eval neff ini/paper/drives/nested.ini neff.png     Neff over a drive\n"
    "  ariadne-eval neff-log truth.tum neff.png --plain a/steps.csv --revisit b/steps.csv\n"
    "  ariadne-eval weights ini/paper/drives/nested_defaults.ini  how far weights are to be "
    "believed\n"
    "Exit code: 0 fine, 1 the run failed, 2 wrong use.";

using Command = int (*)(const std::vector<std::string>&, std::ostream&);
constexpr std::pair<const char*, Command> kCommands[] = {{"plan", eval_app::runPlan},
                                                         {"neff", eval_app::runNeff},
                                                         {"neff-log", eval_app::runNeffLog},
                                                         {"weights", eval_app::runWeights}};

void declare(CLI::App& app, eval_app::Arguments& a) {
  app.footer(kExamples);
  app.add_option("ESTIMATE", a.estimate, "trajectory, TUM format")->required();
  app.add_option("TRUTH", a.truth, "true trajectory, TUM format");
  app.add_option("--relations", a.relations, "verified relations, .gz or not");
  app.add_option("--plot", a.plot, "picture of the errors, .png or .svg");
  app.add_option(
         "--max-gap", a.max_gap_s,
         "seconds between two poses over which the estimate is interpolated; 0: exact stamps")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--delta", a.delta_m, "metres of true travel for the RPE")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e6));
  app.add_flag("--json", a.json, "as JSON");
  app.add_flag("-w,--overwrite", a.overwrite, "replace the plot if it is there");
}

void check(const eval_app::Arguments& a) {
  if (a.truth.empty() && a.relations.empty())
    throw core::UsageError("name a true trajectory or --relations to compare with (see --help)");
  if (!a.plot.empty() && a.truth.empty()) throw core::UsageError("--plot needs a true trajectory");
  if (!a.plot.empty()) eval_app::checkPlotFile(a.plot, a.overwrite);
}

int run(const std::vector<std::string>& args, std::ostream& out) {
  // No CLI subcommand: it would take over the options and required files of the program itself.
  for (const auto& [name, command] : kCommands)
    if (!args.empty() && args.front() == name) return command({args.begin() + 1, args.end()}, out);
  CLI::App app(kAbout, "ariadne-eval");
  eval_app::Arguments a;
  declare(app, a);
  if (!app::parseCommandLine(app, args, out)) return 0;
  check(a);
  const auto evaluation = eval_app::evaluate(a);
  if (a.json)
    eval_app::printJson(evaluation, out);
  else
    eval_app::printText(a, evaluation, out);
  if (!a.plot.empty()) {
    eval_app::writeErrorPlot(a.plot, *evaluation.truth, a.overwrite);
    if (!a.json) out << "\nErrors as a picture: " << a.plot << '\n';
  }
  out.flush();
  if (!out) throw core::Error("cannot write to the standard output");
  return 0;
}

}  // namespace

int runEvalApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err) {
  return app::runProgram("ariadne-eval", err, [&] { return run(args, out); });
}

}  // namespace ariadne
