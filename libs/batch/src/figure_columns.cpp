#include "figure_columns.h"

#include <fmt/format.h>

#include "median_interval.h"

namespace ariadne::batch {
namespace {

using Sample = std::function<const std::vector<double>&(const Cell&)>;
using Median = std::function<std::optional<double>(const Cell&)>;

/// A column of text, or three of CSV.
void add(std::vector<Column>& columns, const std::string& name, bool csv, const char* form,
         const Sample& sample, const Median& median) {
  const auto written = [](const char* how, double v) { return fmt::format(fmt::runtime(how), v); };
  if (!csv) {
    columns.push_back({name, [=](const Cell& c) {
                         const auto m = median(c);
                         if (!m) return std::string();
                         const statistics::Interval i = medianInterval95(sample(c));
                         return fmt::format("{} [{}, {}]", written(form, *m), written(form, i.low),
                                            written(form, i.high));
                       }});
    return;
  }
  columns.push_back({name, [=](const Cell& c) {
                       const auto m = median(c);
                       return m ? fmt::format("{:.10g}", *m) : "";
                     }});
  columns.push_back({name + "_low", [=](const Cell& c) {
                       return median(c) ? fmt::format("{:.10g}", medianInterval95(sample(c)).low)
                                        : "";
                     }});
  columns.push_back({name + "_high", [=](const Cell& c) {
                       return median(c) ? fmt::format("{:.10g}", medianInterval95(sample(c)).high)
                                        : "";
                     }});
}

}  // namespace

void addFigures(std::vector<Column>& columns, const Plan& plan, bool csv) {
  for (std::size_t i = 0; i < plan.figures.size(); ++i)
    add(
        columns, plan.figures[i], csv, "{:.4g}",
        [i](const Cell& c) -> const std::vector<double>& { return c.samples[i]; },
        [i](const Cell& c) { return c.medians[i]; });
  if (plan.arms.size() < 2) return;
  for (std::size_t i = 0; i < plan.relative.size(); ++i)
    add(
        columns,
        csv ? plan.relative[i] + "_change_percent"
            : fmt::format("{} against {}, %", plan.relative[i], plan.arms[0].name),
        csv, "{:+.1f}", [i](const Cell& c) -> const std::vector<double>& { return c.changes[i]; },
        [i](const Cell& c) { return medianOf(c.changes[i]); });
}

}  // namespace ariadne::batch
