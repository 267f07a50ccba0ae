#include "figures.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "ariadne/core/error.h"
#include "ariadne/io/csv.h"
#include "ariadne/io/tum.h"
#include "ariadne/io/whole_file.h"
#include "evaluation.h"
#include "summary.h"

namespace ariadne::compare_app {
namespace {

namespace fs = std::filesystem;

struct Neff {
  double updates = 0;
  double share = 0;  ///< mean of Neff / N behind each update
};

/// Columns neff, resampled and particles of steps.csv, wherever they are.
Neff neffOf(const fs::path& steps_csv) {
  const io::CsvTable steps = io::readCsv(steps_csv);
  const std::size_t left = steps.column("neff");
  const std::size_t of = steps.column("particles");
  const std::size_t resampled = steps.column("resampled");
  Neff neff;
  neff.updates = static_cast<double>(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    neff.share += steps.number(i, resampled) == 1 ? 1 : steps.number(i, left) / steps.number(i, of);
  if (neff.updates > 0) neff.share /= neff.updates;
  return neff;
}

Neff neffOfStock(const fs::path& summary) {
  try {
    const auto json = nlohmann::json::parse(io::readWhole(summary));
    return {json.at("filter").at("updates"), json.at("filter").at("neff_share_after_mean")};
  } catch (const nlohmann::json::exception& e) {
    throw core::Error(fmt::format("{}: {}", summary.string(), e.what()));
  }
}

Figures figuresOf(const fs::path& path, const Neff& neff, const process::ProcessEnd& costs,
                  const References& references) {
  Figures f{{"cpu_s", costs.cpu_s},         {"wall_s", costs.wall_s},
            {"memory_mb", costs.memory_mb}, {"updates", neff.updates},
            {"neff_share", neff.share},     {"length_m", geometry::lengthOf(io::readTum(path))}};
  eval_app::Arguments args;
  args.estimate = path.string();
  args.truth = references.truth;
  args.relations = references.relations;
  args.max_gap_s = references.max_gap_s;
  const auto errors = eval_app::evaluate(args);
  if (errors.truth) {
    f["ate_m"] = errors.truth->absolute_m.rmse;
    f["ate_heading_deg"] = errors.truth->heading_deg.rmse;
    f["rpe_m"] = errors.truth->relative_m.rmse;
    f["rpe_heading_deg"] = errors.truth->relative_deg.rmse;
  }
  if (errors.relations) {
    f["relations_m"] = errors.relations->translation_m.mean;
    f["relations_heading_deg"] = errors.relations->rotation_deg.mean;
  }
  return f;
}

}  // namespace

std::vector<FigureKind> figureKinds(const References& references) {
  std::vector<FigureKind> kinds{
      {"cpu", "s", "CPU time of the process, user and system"},
      {"wall", "s", "wall clock of the process"},
      {"memory", "mb", "peak resident memory, MiB"},
      {"updates", "", "filter updates"},
      {"neff", "share", "mean Neff / N behind an update, 1 where it resampled"},
      {"length", "m", "length of the best path"}};
  if (!references.truth.empty()) {
    kinds.push_back({"ate", "m", "ATE RMSE of the best path"});
    kinds.push_back({"ate_heading", "deg", "RMSE of its heading"});
    kinds.push_back({"rpe", "m", "RPE RMSE over 1 m"});
    kinds.push_back({"rpe_heading", "deg", "RPE RMSE of the heading"});
  }
  if (!references.relations.empty()) {
    kinds.push_back({"relations", "m", "mean relations error"});
    kinds.push_back({"relations_heading", "deg", "mean relations error of the heading"});
  }
  return kinds;
}

Figures figuresOfOurs(const fs::path& folder, const process::ProcessEnd& costs,
                      const References& references) {
  return figuresOf(folder / "trajectory.tum", neffOf(folder / "steps.csv"), costs, references);
}

Figures figuresOfStock(const fs::path& folder, const process::ProcessEnd& costs,
                       const References& references) {
  return figuresOf(folder / "path.tum", neffOfStock(folder / "summary.json"), costs, references);
}

}  // namespace ariadne::compare_app
