#include "run_options.h"

namespace ariadne::app {

void declareRunOptions(CLI::App& app, RunOptions& o, const std::string& input) {
  app.add_option("--set", o.settings, "section.key=value; may be given again and again")
      ->allow_extra_args(false)
      ->take_all();
  app.add_option("--particles", o.particles, "number of particles");
  app.add_option("--seed", o.seed, "same seed, same result, on any number of threads");
  app.add_option("--threads", o.threads, "0: one per core");
  app.add_option("--out", o.out,
                 "folder to write to; default: ariadne-<" + input + ">-<date>-<time>");
  app.add_flag("--overwrite", o.overwrite,
               "replace the files of an earlier run in that folder; others stay");
  app.add_flag("--no-pictures", o.no_pictures, "write no PNG files and no report.html");
  app.add_flag("--print-config", o.print_config, "print the resolved INI and stop");
  app.add_flag("--print-parameters", o.print_parameters,
               "print the page of all parameters (Markdown) and stop");
  app.add_flag("--quiet", o.quiet, "print only warnings and errors");
}

std::vector<io::IniEntry> flagEntries(const RunOptions& o) {
  std::vector<io::IniEntry> entries;
  if (o.particles) entries.push_back({"filter", "particles", *o.particles, "--particles"});
  if (o.seed) entries.push_back({"filter", "seed", *o.seed, "--seed"});
  if (o.threads) entries.push_back({"run", "threads", *o.threads, "--threads"});
  if (o.out) entries.push_back({"run", "out", *o.out, "--out"});
  if (o.no_pictures) entries.push_back({"run", "pictures", "false", "--no-pictures"});
  return entries;
}

}  // namespace ariadne::app
