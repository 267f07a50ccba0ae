#include "ariadne/experiment/loop_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "ariadne/eval/exact_tests.h"
#include "ariadne/eval/interval.h"

namespace ariadne::experiment {
namespace {

using Group = std::vector<const LoopRow*>;

std::map<std::pair<std::string, int>, Group> grouped(const std::vector<LoopRow>& rows) {
  std::map<std::pair<std::string, int>, Group> groups;
  for (const LoopRow& r : rows) groups[{r.name, r.laps}].push_back(&r);
  return groups;
}

std::size_t countOf(const Group& group, const std::function<bool(const LoopRunResult&)>& f) {
  return static_cast<std::size_t>(
      std::count_if(group.begin(), group.end(), [&](const LoopRow* r) { return f(r->result); }));
}

/// "40/60 (67 % [54-77])".
std::string rate(std::size_t n, std::size_t of) {
  const auto i = eval::wilsonInterval(n, of);
  return fmt::format("{}/{} ({:.0f} % [{:.0f}-{:.0f}])", n, of,
                     100.0 * static_cast<double>(n) / static_cast<double>(of), 100 * i.low,
                     100 * i.high);
}

std::string median(const Group& group, const std::function<double(const LoopRunResult&)>& f,
                   bool inner) {
  std::vector<double> values;
  for (const LoopRow* r : group)
    if (!inner || r->result.inner) values.push_back(f(r->result));
  if (values.empty()) return "";
  std::sort(values.begin(), values.end());
  const std::size_t m = values.size() / 2;
  return fmt::format("{:.2f}",
                     values.size() % 2 == 1 ? values[m] : (values[m - 1] + values[m]) / 2);
}

std::string rates(const std::vector<LoopRow>& rows) {
  std::string out =
      "| drive | laps | standard chosen | standard exists | recovery chosen | recovery exists | "
      "only recovery / only standard | McNemar p | median of the largest closure error, m: "
      "standard, recovery |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [key, g] : grouped(rows)) {
    const auto gained =
        countOf(g, [](const auto& r) { return r.recovered.chosen && !r.standard.chosen; });
    const auto lost =
        countOf(g, [](const auto& r) { return !r.recovered.chosen && r.standard.chosen; });
    out += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} / {} | {:.2g} | {}, {} |\n", key.first, key.second,
        rate(countOf(g, [](const auto& r) { return r.standard.chosen; }), g.size()),
        rate(countOf(g, [](const auto& r) { return r.standard.exists; }), g.size()),
        rate(countOf(g, [](const auto& r) { return r.recovered.chosen; }), g.size()),
        rate(countOf(g, [](const auto& r) { return r.recovered.exists; }), g.size()), gained, lost,
        eval::mcnemarTest(gained, lost),
        median(
            g, [](const auto& r) { return r.standard.worst_translation_m; }, false),
        median(
            g, [](const auto& r) { return r.recovered.worst_translation_m; }, false));
  }
  return out;
}

std::string losses(const std::vector<LoopRow>& rows) {
  std::string out =
      "| drive | laps | runs with a recovery | survivors at detection | ancestors at te left, "
      "recovered | least error at te, m: existed, saved, left | KL saved, left (nats) | slope of "
      "ln Neff in the closing, per 10 m | resamplings in it "
      "|\n|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& [key, g] : grouped(rows)) {
    const auto m = [&, &group = g](auto member, double scale = 1) {
      return median(
          group,
          [&](const LoopRunResult& r) { return scale * static_cast<double>((*r.inner).*member); },
          true);
    };
    out += fmt::format(
        "| {} | {} | {} | {} | {}, {} | {}, {}, {} | {}, {} | {} | {} |\n", key.first, key.second,
        countOf(g, [](const auto& r) { return r.inner.has_value(); }), m(&InnerLoop::survivors),
        m(&InnerLoop::distinct_left), m(&InnerLoop::distinct_saved), m(&InnerLoop::existed_error_m),
        m(&InnerLoop::saved_error_m), m(&InnerLoop::left_error_m), m(&InnerLoop::kl_saved_nats),
        m(&InnerLoop::kl_left_nats), m(&InnerLoop::neff_slope_per_m, 10),
        m(&InnerLoop::resamplings));
  }
  return out;
}

}  // namespace

std::string loopTable(const std::vector<LoopRow>& rows) {
  return rates(rows) + "\nMedians over the runs with a recovery:\n\n" + losses(rows);
}

}  // namespace ariadne::experiment
